/* The page for lost links: what stands after # in a link is all that the lab needs, wherever the link led. */

const { hash } = location
if (hash.includes('=')) {
  const kept = document.querySelector<HTMLElement>('#kept')!
  kept.querySelector('a')!.hash = hash
  kept.hidden = false
}
