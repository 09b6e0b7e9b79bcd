/** The folder that the lab's own pages are in: undefined where this page is one of them, null where none is known. */
let folder: string | null | undefined

/** Finds out whether they are somewhere, once somebody needs to know. */
let finding: (() => Promise<string | null>) | undefined

const followers = new Set<() => void>()

/**
 * The address that links to the lab start from: this page's, without what it says of the lab, or a folder's; null where
 * there is no lab to link to. In a page that was opened from a file, which nobody else can open, it is where the site was
 * said to be when it was built.
 */
export function site(): string | null {
  if (finding) {
    void finding().then((found) => {
      if (found && folder === null) setSite(found)
    })
    finding = undefined
  }
  if (folder !== undefined) return folder
  const { href, protocol } = location
  return protocol === 'file:' && published ? published : href.replace(/#.*/s, '')
}

/** Where the site was said to be when this was built: `VITE_SITE`; null if nothing was said. */
export const published: string | null =
  import.meta.env.VITE_SITE === './' ? null : (import.meta.env.VITE_SITE as string | null)

/** Whether other people can open what links lead to. */
export function isPublic(): boolean {
  return !site()?.startsWith('file:')
}

/**
 * Tells the elements where the lab's own pages are, for the links that lead there.
 *
 * @param address of a folder, with its slash; null for nowhere: then there are no such links
 */
export function setSite(address: string | null): void {
  folder = address
  finding = undefined
  for (const callback of followers) callback()
}

/** Leaves it open where the lab's own pages are, until a link needs them. */
export function findSite(find: () => Promise<string | null>): void {
  finding = find
}

/** Calls back when it becomes known that the lab's pages are elsewhere. Returns a function that unsubscribes. */
export function onSiteChange(callback: () => void): () => void {
  followers.add(callback)
  return () => followers.delete(callback)
}

/** Whether this page is one of the lab's own. */
export function isAtHome(): boolean {
  return folder === undefined
}
