/*
 * For pages that have frames of Any Frame Rate: gives each frame the height of the figure in it, and the figure the
 * theme of the page, which shows through only then.
 *
 *     <script src="…/embed-resize.js" async></script>
 *
 * The page says { type: 'any-frame-rate:hello', theme } to a frame that has been loaded, with `light` or `dark` as theme,
 * and again when that changes. It says so to whoever is in there, since a sandboxed frame has no origin that could be
 * named; nothing in it is secret. The frame answers { type: 'any-frame-rate:height', height } with a whole number of CSS
 * pixels, at once and whenever it changes, to the page and the origin that greeted it. An answer is taken only from the
 * very window of a frame, and from the origin of its address or, where it is sandboxed, from none.
 */
{
  const FRAMES = 'iframe[src*="/embed.html"]'

  /** No figure is higher [px]. */
  const HIGHEST = 5000

  const hello = (frame) => {
    if (!frame.matches?.(FRAMES)) return
    // A property that shows nothing in a frame, but the colour scheme that the frame is in, and when that changes.
    frame.style.columnRuleColor = 'light-dark(#000, #fff)'
    frame.style.transition = 'column-rule-color 1ms'
    const isDark = getComputedStyle(frame).columnRuleColor === 'rgb(255, 255, 255)'
    const theme = isDark ? 'dark' : 'light'
    frame.contentWindow.postMessage({ type: 'any-frame-rate:hello', theme }, '*')
  }

  addEventListener('message', ({ data, source, origin }) => {
    if (data?.type !== 'any-frame-rate:height') return
    const { height } = data
    if (!Number.isInteger(height) || height < 1 || height > HIGHEST) return
    for (const frame of document.querySelectorAll(FRAMES))
      if (frame.contentWindow === source && ['null', new URL(frame.src).origin].includes(origin))
        frame.style.height = `${height}px`
  })

  // Frames that come later too: an element's load does not rise, but it can be seen on its way down.
  document.addEventListener('load', ({ target }) => hello(target), true)
  document.addEventListener('transitionrun', ({ target }) => hello(target))
  document.querySelectorAll(FRAMES).forEach(hello)
}
