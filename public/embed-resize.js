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
 *
 * A router that runs the script again with each of its pages only has it greet the frames that are there.
 */
{
  const FRAMES = 'iframe[src*="/embed.html"]'

  /** No figure is higher [px]. */
  const HIGHEST = 5000

  const frames = () => document.querySelectorAll(FRAMES)

  /** The theme that each frame was told last. */
  const told = new WeakMap()

  const hello = (frame) => {
    if (!frame.matches?.(FRAMES)) return
    // Else it would have its height only when it is scrolled to, and the page would leap there.
    frame.loading = 'eager'
    const theme = themeOf(frame)
    told.set(frame, theme)
    frame.contentWindow.postMessage({ type: 'any-frame-rate:hello', theme }, '*')
  }

  /** The theme of the page around a frame, which the frame has from then on. */
  const themeOf = (frame) => {
    const set = (name, value) => frame.style.setProperty(name, value, 'important')
    // A property that shows nothing in a frame, but the scheme that it is in.
    const scheme = () => getComputedStyle(frame).columnRuleColor
    set('transition', 'none')
    set('column-rule-color', 'light-dark(#000, #fff)')
    // The page may have a scheme for frames, but only in the page's own does a frame let the page show through.
    set('color-scheme', 'inherit')
    const theme = scheme() === 'rgb(255, 255, 255)' || isOnDark(frame) ? 'dark' : 'light'
    set('color-scheme', theme === 'dark' ? 'dark' : 'inherit')
    // Asked for again, so that no transition comes of that.
    scheme()
    set('transition', 'column-rule-color 1ms step-start')
    return theme
  }

  /** Whether the nearest background behind an element is dark. */
  const isOnDark = (element) => {
    for (let each = element.parentElement; each; each = each.parentElement) {
      const colour = getComputedStyle(each).backgroundColor
      const [a, b, c, alpha = 1] = (colour.match(/-?[\d.]+(e-?\d+)?/g) ?? []).map(Number)
      if (alpha < 0.5) continue
      if (/^(ok)?l/.test(colour)) return a < (colour[0] === 'o' ? 0.5 : 50)
      return 0.2126 * a + 0.7152 * b + 0.0722 * c < (colour.startsWith('rgb') ? 127.5 : 0.5)
    }
    return false
  }

  const listen = () => {
    const settings = new MutationObserver(() => again())
    const again = () => {
      for (const frame of frames()) {
        if (themeOf(frame) !== told.get(frame)) hello(frame)
        // A router may have put other ones around it.
        for (let each = frame.parentElement; each; each = each.parentElement)
          settings.observe(each, { attributes: true })
      }
    }

    addEventListener('message', ({ data, source, origin }) => {
      if (data?.type !== 'any-frame-rate:height') return
      const { height } = data
      if (!Number.isInteger(height) || height < 1 || height > HIGHEST) return
      for (const frame of frames())
        if (frame.contentWindow === source && ['null', new URL(frame.src).origin].includes(origin))
          frame.style.height = `${height}px`
    })

    const greet = (frame) => {
      hello(frame)
      again()
    }
    // Frames that come later too: an element's load does not rise, but it can be seen on its way down.
    document.addEventListener(
      'load',
      ({ target }) => (target.localName === 'link' ? again() : greet(target)),
      true,
    )
    // What themes change: the scheme, a background, attributes of the page, a style sheet, the system's setting.
    document.addEventListener('transitionrun', ({ target }) => {
      if (target.matches?.(FRAMES)) again()
    })
    document.addEventListener('transitionend', ({ propertyName }) => {
      if (propertyName === 'background-color') again()
    })
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', again)
    settings.observe(document.head, { attributes: true, childList: true, subtree: true })
    again()
  }

  const isListening = Symbol.for('any-frame-rate:embed-resize')
  if (!window[isListening]) listen()
  window[isListening] = true
  frames().forEach(hello)
}
