import type { MarkdownIt } from 'markdown-it'

/** What stands in `{{…}}`: a fact by name, or a number of a figure that can be dragged. */
export type Brace =
  | { readonly kind: 'fact'; readonly name: string }
  | {
      readonly kind: 'dial'
      readonly figure: string
      readonly control: string
      readonly value: string
      readonly unit: string
    }

/** `{{name}}` and `{{figure.control=15 unit}}`. */
export function braces(md: MarkdownIt): void {
  md.inline.ruler.before('escape', 'brace', (state, silent) => {
    const match = /^\{\{([^{}]*)\}\}/.exec(state.src.slice(state.pos, state.posMax))
    if (!match) return false
    if (!silent) state.push('brace', '', 0).meta = braceOf(match[1]!.trim())
    state.pos += match[0].length
    return true
  })
}

/** Reads what stands between the braces. */
function braceOf(text: string): Brace {
  const dial = /^([\w-]+)\.(\w+)\s*=\s*(\S+)(?:\s+(.+))?$/.exec(text)
  if (!dial) return { kind: 'fact', name: text }
  const [, figure, control, value, unit = ''] = dial
  return { kind: 'dial', figure: figure!, control: control!, value: value!.replace('−', '-'), unit }
}
