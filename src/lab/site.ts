/** The folder that the lab's own pages are in, where that is not this page's. */
let elsewhere: string | undefined

/**
 * The address that links to the lab start from: this page's, without what it says of the lab, or a folder's. Of a page
 * that was opened from a file, which nobody else can open, it is where the site was said to be when it was built.
 */
export function site(): string {
  if (elsewhere !== undefined) return elsewhere
  const published = import.meta.env.VITE_SITE as string
  const { href, protocol } = location
  return protocol === 'file:' && published !== './' ? published : href.replace(/#.*/s, '')
}

/** Whether other people can open what links lead to. */
export function isPublic(): boolean {
  return !site().startsWith('file:')
}

/** Tells elements in other people's pages where the lab's own pages are: the address of a folder, with its slash. */
export function setSite(folder: string): void {
  elsewhere = folder
}

/** Whether this page is one of the lab's own. */
export function isAtHome(): boolean {
  return elsewhere === undefined
}
