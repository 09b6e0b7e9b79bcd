/* The page for frames of other pages: one lab, without the rest of the page around it. */
import { defineLab } from './panels/slideLab.ts'

defineLab()
answerPage(document.querySelector('main')!)

/**
 * Lets a figure in a frame and the page around it get along, if that page asks for it:
 *
 * - the page says `{ type: 'any-frame-rate:hello', theme }` with the theme `light` or `dark` that it has around the frame,
 *   again whenever that changes. The frame takes it for its own: a frame of another theme than the page is not transparent
 * - the frame answers `{ type: 'any-frame-rate:height', height }`, a whole number of CSS pixels, at once and whenever it
 *   changes. From then on the document's root has the attribute `data-fitted`, and the figure no longer fills the frame
 *
 * A greeting from any other window than the page's is passed over. Answers go to that window alone, and only as long as
 * what is in it is of the origin that the greeting came from; a page without an origin, as from a file, can't be named.
 *
 * The page's side is `public/embed-resize.js`.
 */
function answerPage(content: HTMLElement): void {
  const page = window.parent
  const { documentElement: root } = document
  let origin: string | undefined
  let told = 0
  const tell = () => {
    const height = Math.ceil(content.getBoundingClientRect().height)
    if (origin === undefined || height === told) return
    told = height
    page.postMessage({ type: 'any-frame-rate:height', height }, origin)
  }
  addEventListener('message', (event: MessageEvent<{ type?: unknown; theme?: unknown } | null>) => {
    const { data, source } = event
    if (page === window || source !== page || data?.type !== 'any-frame-rate:hello') return
    origin = event.origin === 'null' ? '*' : event.origin
    root.toggleAttribute('data-fitted', true)
    if (data.theme === 'light' || data.theme === 'dark') root.dataset.theme = data.theme
    told = 0
    tell()
  })
  new ResizeObserver(tell).observe(content)
  // Of a frame that is not in view nothing is drawn, so that no size is observed.
  new MutationObserver(tell).observe(content, { childList: true, subtree: true })
  document.fonts.addEventListener('loadingdone', tell)
}
