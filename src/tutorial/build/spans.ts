import type { MarkdownIt } from 'markdown-it'

/** The classes that words and symbols may have: what the picture draws in a colour of its own. */
export const words: readonly string[] = ['gravity', 'normal', 'friction', 'sum', 'velocity']

/** `[words]{.class}` and `[term]{#id}`: in brackets what is meant, in braces what it is. */
export function spans(md: MarkdownIt): void {
  md.inline.ruler.before('link', 'span', (state, silent) => {
    const { src, pos } = state
    if (src[pos] !== '[') return false
    const end = md.helpers.parseLinkLabel(state, pos)
    if (end < 0) return false
    const brace = /^\{([.#][\w-]+)\}/.exec(src.slice(end + 1))
    if (!brace) return false
    if (!silent) {
      const name = brace[1]!
      const tag = name.startsWith('#') ? 'dfn' : 'span'
      const open = state.push('span_open', tag, 1)
      open.meta = { name: name.slice(1) }
      const { posMax } = state
      state.pos = pos + 1
      state.posMax = end
      md.inline.tokenize(state)
      state.posMax = posMax
      state.push('span_close', tag, -1)
    }
    state.pos = end + 1 + brace[0].length
    return true
  })
}
