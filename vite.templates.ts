import { parseSync, Visitor } from 'vite'
import type { Plugin } from 'vite'

/**
 * Takes the indentation out of the templates of Lit: a line break with all the space around it becomes one space, which a
 * browser shows the same.
 */
export function flatTemplates(): Plugin {
  return {
    name: 'flat-templates',
    apply: 'build',
    transform: {
      filter: { id: /\/src\/.*\.ts$/, code: /\b(?:html|svg)`/ },
      handler(code, id) {
        const parts: { start: number; end: number }[] = []
        new Visitor({
          TaggedTemplateExpression({ tag, quasi }) {
            if (tag.type === 'Identifier' && /^(html|svg)$/.test(tag.name))
              parts.push(...quasi.quasis)
          },
        }).visit(parseSync(id, code).program)
        let flat = ''
        let done = 0
        for (const { start, end } of parts.sort((a, b) => a.start - b.start)) {
          flat += code.slice(done, start) + code.slice(start, end).replace(/\s*\n\s*/g, ' ')
          done = end
        }
        return { code: flat + code.slice(done), map: null }
      },
    },
  }
}
