/** The folder that the lab's own pages are in, where that is not this page's. */
let elsewhere: string | undefined

/** The address that links to the lab start from: this page's, without what it says of the lab, or a folder's. */
export function site(): string {
  return elsewhere ?? location.href.replace(/#.*/s, '')
}

/** Tells elements in other people's pages where the lab's own pages are: the address of a folder, with its slash. */
export function setSite(folder: string): void {
  elsewhere = folder
}

/** Whether this page is one of the lab's own. */
export function isAtHome(): boolean {
  return elsewhere === undefined
}
