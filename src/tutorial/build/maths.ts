import type { MarkdownIt } from 'markdown-it'
import temml from 'temml'
import { words } from './spans.ts'

/**
 * `$…$` in a line and `$$…$$` on lines of its own. A dollar that is followed or preceded by a space is a dollar, so that
 * prices need no backslash.
 */
export function maths(md: MarkdownIt): void {
  md.inline.ruler.before('escape', 'maths', (state, silent) => {
    const { src, pos } = state
    if (src[pos] !== '$' || /[\s$]/.test(src[pos + 1] ?? ' ')) return false
    let end = pos + 1
    while (end < state.posMax && src[end] !== '$') end += src[end] === '\\' ? 2 : 1
    if (end >= state.posMax || /\s/.test(src[end - 1]!)) return false
    if (!silent) state.push('maths', 'math', 0).content = src.slice(pos + 1, end)
    state.pos = end + 1
    return true
  })
  md.block.ruler.before(
    'fence',
    'equation',
    (state, first, last, silent) => {
      const line = (index: number) =>
        state.src.slice(state.bMarks[index]! + state.tShift[index]!, state.eMarks[index])
      if (!line(first).startsWith('$$')) return false
      let end = first
      // The closing dollars may stand on the line of the opening ones.
      while (end < last && !(line(end).endsWith('$$') && (end > first || line(end).length > 3)))
        end++
      if (end === last) return false
      if (silent) return true
      const token = state.push('equation', 'math', 0)
      const lines = Array.from({ length: end - first + 1 }, (_, i) => line(first + i)).join('\n')
      token.content = lines
        .replace(/^\$\$/, '')
        .replace(/\$\$\s*$/, '')
        .trim()
      token.map = [first, end + 1]
      state.line = end + 1
      return true
    },
    { alt: ['paragraph', 'reference', 'blockquote', 'list'] },
  )
}

/**
 * TeX as MathML. `\class{friction}{…}` gives a symbol its force's colour.
 *
 * @throws an error that says what of it isn't TeX
 */
export function mathml(tex: string, display: boolean): string {
  return temml.renderToString(tex, {
    displayMode: display,
    throwOnError: true,
    // Only classes that the style sheet knows: anything else would be a misprint.
    trust: ({ command, class: name }: { command: string; class?: string }) =>
      command === '\\class' && name !== undefined && words.includes(name),
  })
}
