import { EarlyLinks } from './tutorial/earlyLinks.ts'

const links = new EarlyLinks()

// Text and pictures are shown first, then they come alive: in a task of its own after the first frame.
requestAnimationFrame(() => setTimeout(comeAlive))

async function comeAlive(): Promise<void> {
  await import('./panels/define.ts')
  // The lab comes first: the figures are pictures until they are near, and the text needs no script.
  await import('./reading.ts')
  links.follow()
}
