import { resolve } from 'node:path'
import { runnerImport } from 'vite'
import type { Plugin } from 'vite'
import type * as Load from './load.ts'

/** What stands in pages in place of the tutorial, and of the lab's still. */
const TUTORIAL = '<!-- tutorial -->'
const LAB = '<!-- lab -->'

/** The folder of the styles that single elements of a page's text have: one for each page. */
const STYLES = '/tutorial-styles/'

/**
 * Puts the tutorial into the page: the text of src/tutorial/text, its numbers, its figures’ stills. In development a
 * change of any of them shows at once.
 */
export function tutorial(): Plugin {
  let root = ''
  /** What the page was made of last. */
  let sources = new Set<string>()
  const styles = new Map<string, string>()
  return {
    name: 'tutorial',
    configResolved: (config) => void (root = config.root),
    resolveId: (id) => (id.startsWith(STYLES) ? id : null),
    load: (id) => (id.startsWith(STYLES) ? (styles.get(id.replace(/\?.*/, '')) ?? '') : null),
    transformIndexHtml: {
      order: 'pre',
      handler: async (html, { server, path }) => {
        if (!html.includes(TUTORIAL) && !html.includes(LAB)) return html
        const { module, dependencies } = await runnerImport<typeof Load>(
          resolve(root, 'src/tutorial/build/load.ts'),
          { root, configFile: false, logLevel: 'silent' },
        )
        const texts = resolve(root, 'src/tutorial/text')
        sources = new Set(dependencies.map((path) => resolve(root, path)))
        server?.watcher.add([texts, ...sources])
        const ids = [...html.matchAll(/\sid="([^"]+)"/g)].map((match) => match[1]!)
        const filled = html
          .replace(TUTORIAL, () => module.tutorialArticle(root, ids))
          .replace(LAB, () => module.labStill())
        const page = styleClasses(filled)
        const address = path.replace(/^.*\/(.*)\.html$/, `${STYLES}$1.css`)
        styles.set(address, page.css)
        const link = `<link rel="stylesheet" href="${address}" />`
        return page.html.replace('</head>', `${link}</head>`)
      },
    },
    handleHotUpdate: ({ file, server }) => {
      if (!file.endsWith('.md') && !sources.has(file)) return
      server.ws.send({ type: 'full-reload' })
    },
  }
}

/**
 * HTML whose style attributes are classes, and the rules of these: a host may forbid styles in the page itself, and a
 * rule that many elements share is written once.
 */
export function styleClasses(html: string): { html: string; css: string } {
  const names = new Map<string, string>()
  const bare = html.replace(/<[a-z][^<>]*\sstyle="([^"]*)"[^<>]*>/g, (tag, style: string) => {
    const name = names.get(style) ?? `style-${names.size}`
    names.set(style, name)
    const rest = tag.replace(/\sstyle="[^"]*"/, '')
    return rest.includes(' class="')
      ? rest.replace(' class="', ` class="${name} `)
      : rest.replace(/^<[\w-]+/, `$& class="${name}"`)
  })
  const rules = [...names].map(([style, name]) => `.${name} { ${style} }\n`)
  return { html: bare, css: rules.join('') }
}
