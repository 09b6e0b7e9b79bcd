import type { MarkdownIt } from 'markdown-it'
import { codeHtml, sourceHtml, takeHomeHtml } from './code.ts'
import type { Env } from './env.ts'
import { figureHtml } from './figures.ts'
import { hardCasesHtml } from './hardCases.ts'

/** Fenced blocks: a figure, lines of the project's own source, the take-home files, the hard cases, or code in a language. */
export function fences(md: MarkdownIt): void {
  md.renderer.rules.fence = (tokens, index, _options, given) => {
    const env = given as Env
    const { info, content, map } = tokens[index]!
    const line = map?.[0] ?? 0
    const [kind = '', argument = ''] = info.trim().split(/\s+/)
    if (kind === 'take-home') return takeHomeHtml(env, line)
    if (kind === 'hard-cases') return hardCasesHtml(env, line)
    if (kind !== 'figure' && kind !== 'source') return codeHtml(env, content, kind, line)
    const caption = md.render(content, { ...env, firstLine: env.firstLine + line + 1 }).trim()
    return kind === 'figure'
      ? figureHtml(env, argument, caption, line)
      : sourceHtml(env, argument, caption, line)
  }
}
