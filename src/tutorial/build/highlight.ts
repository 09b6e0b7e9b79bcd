import { createCssVariablesTheme, createHighlighter } from 'shiki'
import { escaped } from '../still/html.ts'
import { words } from './spans.ts'

/** Turns source text into HTML, a `<span>` a line. */
export type Highlight = (code: string, language: string) => string

/** What source texts may be written in. */
export const languages = ['ts', 'js', 'cpp', 'csharp', 'gdscript', 'json', 'sh'] as const

/** The theme says only what a piece is; reading.css says how that looks in light and dark. */
const theme = createCssVariablesTheme({ name: 'page', variablePrefix: '--', fontStyle: false })

/** By what the theme calls a piece. What is not here looks like the rest. */
const classes: Readonly<Record<string, string>> = {
  'var(--token-keyword)': 'keyword',
  'var(--token-comment)': 'comment',
  'var(--token-constant)': 'number',
  'var(--token-string)': 'string',
  'var(--token-string-expression)': 'string',
  'var(--token-function)': 'name',
}

/** The names of forces among other letters. */
const forces = new RegExp(`\\b(${words.join('|')})\\b`)

/** Whether a piece is for people: comments and strings. */
function isTold(colour: string): boolean {
  return ['comment', 'string'].includes(classes[colour] ?? '')
}

/** Loads the grammars, which takes a moment, and gives what highlights with them. */
export async function highlighter(): Promise<Highlight> {
  const shiki = await createHighlighter({ themes: [theme], langs: [...languages] })
  return (code, language) => {
    const { tokens } = shiki.codeToTokens(code, {
      lang: language as (typeof languages)[number],
      theme: 'page',
      // However slow the machine: a line that took too long would be left plain.
      tokenizeTimeLimit: 0,
    })
    return tokens.map((line) => `<span class="line">${lineHtml(line)}</span>`).join('\n')
  }
}

/** Neighbours of one kind are one piece: a page of code has thousands. */
function lineHtml(
  tokens: readonly { readonly content: string; readonly color?: string }[],
): string {
  const pieces: { kind: string; text: string }[] = []
  for (const { content, color = '' } of tokens) {
    for (const text of isTold(color) ? [content] : content.split(forces)) {
      const kind = kindOf(text, color, pieces.at(-1)?.kind ?? '')
      if (pieces.at(-1)?.kind === kind) pieces.at(-1)!.text += text
      else pieces.push({ kind, text })
    }
  }
  return pieces
    .map(({ kind, text }) =>
      kind ? `<span class="${kind}">${escaped(text)}</span>` : escaped(text),
    )
    .join('')
}

/**
 * What a piece looks like. Names of forces have the colours that these have in text and picture; signs without a letter
 * or digit in them, such as `=` and `:`, stay in ink: the eye looks for words.
 */
function kindOf(content: string, colour: string, before: string): string {
  if (content.trim() === '') return before
  if (words.includes(content) && !isTold(colour)) return content
  const kind = classes[colour] ?? ''
  return kind === 'keyword' && !/\w/.test(content) ? '' : kind
}
