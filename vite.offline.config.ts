import { readFileSync } from 'node:fs'
import { extname, join, resolve } from 'node:path'
import { defineConfig } from 'vite'
import type { Plugin } from 'vite'
import { flatTemplates } from './vite.templates.ts'

const entry = 'virtual:offline'

/**
 * The page that was just built as one file beside it, `offline.html`, which asks for no other: for a classroom without
 * network. Only its scripts are built anew, in one piece; text, figures and styles are those of the built `index.html`.
 */
export default defineConfig({
  base: './',
  publicDir: false,
  plugins: [flatTemplates(), scriptsOfThePage(), nothingByAddress(), oneFile()],
  build: {
    target: 'es2022',
    emptyOutDir: false,
    modulePreload: false,
    rolldownOptions: { input: entry, output: { codeSplitting: false } },
  },
  // A page that was opened from a file may have workers of text, and only classic ones in every browser.
  worker: { format: 'iife' },
})

/** What index.html runs, in its order. */
function scriptsOfThePage(): Plugin {
  const source = readFileSync(resolve(import.meta.dirname, 'index.html'), 'utf8')
  const scripts = [...source.matchAll(/<script type="module" src="([^"]+)"/g)]
  return {
    name: 'scripts-of-the-page',
    resolveId: (id) => (id === entry ? `\0${entry}` : null),
    load: (id) =>
      id === `\0${entry}` ? scripts.map(([, src]) => `import '${src}'\n`).join('') : null,
  }
}

/** What the page would load by an address while it runs becomes part of its script. */
function nothingByAddress(): Plugin {
  const changes = [
    {
      file: 'measurer.ts',
      from: "new Worker(new URL('./measureWorker.ts', import.meta.url), { type: 'module' })",
      to: 'new MeasureWorker()',
      with: "import MeasureWorker from './measureWorker.ts?worker&inline'",
    },
    {
      file: 'fetchReport.ts',
      from: "await fetch(new URL('report/report.json', home))",
      to: 'new Response(report)',
      with: "import report from '/public/report/report.json?raw'",
    },
  ]
  return {
    name: 'nothing-by-address',
    enforce: 'pre',
    transform: {
      filter: { id: /\/(measurer|fetchReport)\.ts$/ },
      handler(code, id) {
        const change = changes.find(({ file }) => id.endsWith(`/${file}`))!
        if (!code.includes(change.from)) throw new Error(`${id} does not have ${change.from}`)
        return { code: `${change.with}\n${code.replace(change.from, change.to)}`, map: null }
      },
    },
  }
}

/** Writes the built page with all that it links to in it. */
function oneFile(): Plugin {
  let folder = ''
  const built = (address: string) => readFileSync(join(folder, address))
  const data = (address: string) =>
    `data:${types[extname(address)]};base64,${built(address).toString('base64')}`

  return {
    name: 'one-file',
    configResolved: ({ root, build }) => void (folder = resolve(root, build.outDir)),
    generateBundle: {
      // After Vite's own work on the scripts.
      order: 'post',
      handler(_, bundle) {
        const [chunk, ...others] = Object.values(bundle)
        if (chunk?.type !== 'chunk' || others.length > 0)
          this.error(`The scripts are not one file: ${Object.keys(bundle).join(', ')}`)
        Reflect.deleteProperty(bundle, chunk.fileName)

        let style = ''
        const page = built('index.html')
          .toString()
          .replace(/\s*<script\b[^>]*\ssrc=[^>]*><\/script>/g, '')
          // What is only for a page that has an address.
          .replace(/\s*<link[^>]*\srel="(?:modulepreload|preload|canonical)"[^>]*>/g, '')
          .replace(/\s*<meta[^>]*\s(?:property="og:|name="twitter:)[^>]*>/g, '')
          .replace(/\s*<(\w+)[^>]*\sdata-online\b[^]*?<\/\1>/g, '')
          .replace(/\s*<link[^>]*\srel="stylesheet"[^>]*\shref="([^"]+)"[^>]*>/g, (_, address) => {
            style += built(address as string)
            return ''
          })
          .replace(/(?<=<link rel="icon" href=")[^"]+/, data)
          .replaceAll('href="./"', 'href="#"')
          .replace('</head>', () => `  <style>${withFonts(style)}</style>\n  </head>`)
        const asked = /\s(?:src|href)="(?!#|data:|https?:)[^"]*"|url\(["']?[./][^)]*\)/g
        const left = new Set(page.match(asked))
        if (left.size > 0) this.error(`The one file would ask for others: ${[...left].join(', ')}`)

        // In a script these would end it, or hide its end.
        const script = chunk.code.replace(/<(?=\/script|!--)/gi, '\\x3C')
        this.emitFile({
          type: 'asset',
          fileName: 'offline.html',
          source: page.replace('</body>', () => `<script type="module">${script}</script></body>`),
        })
      },
    },
  }

  function withFonts(style: string): string {
    return style.replace(/url\((\.\/[^)]+\.woff2)\)/g, (_, font) => {
      return `url(${data(join('assets', font as string))})`
    })
  }
}

const types: Record<string, string> = { '.svg': 'image/svg+xml', '.woff2': 'font/woff2' }
