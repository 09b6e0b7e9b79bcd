import type { Plugin, Rolldown } from 'vite'

/**
 * Has the front page carry its styles: its first paint waits for one file, not for three. The styles' own addresses,
 * those of the fonts, are relative to the page then. A file of styles that no page asks for any more is not written.
 */
export function inlineStyles(page: string): Plugin {
  return {
    name: 'inline-styles',
    apply: 'build',
    enforce: 'post',
    transformIndexHtml: {
      order: 'post',
      handler(html, { path, bundle = {} }) {
        if (path !== page) return
        let styles = ''
        const rest = html.replace(
          /\s*<link rel="stylesheet"[^>]* href="\.\/([^"]+)">/g,
          (_, file) => {
            const folder = (file as string).replace(/[^/]*$/, '')
            styles += text(bundle[file as string]).replaceAll('url(./', `url(./${folder}`)
            return ''
          },
        )
        if (!styles) throw new Error(`${page} links to no styles that could be put into it`)
        return rest.replace('</head>', () => `  <style>${styles}</style>\n  </head>`)
      },
    },
    generateBundle: {
      order: 'post',
      handler(_, bundle) {
        const pages = Object.values(bundle).filter(({ fileName }) => fileName.endsWith('.html'))
        for (const { fileName } of Object.values(bundle))
          if (fileName.endsWith('.css') && !pages.some((each) => text(each).includes(fileName)))
            Reflect.deleteProperty(bundle, fileName)
      },
    },
  }
}

function text(file: Rolldown.OutputAsset | Rolldown.OutputChunk | undefined): string {
  if (file?.type !== 'asset') throw new Error(`${file?.fileName} is no file that was written`)
  const { source } = file
  return typeof source === 'string' ? source : new TextDecoder().decode(source)
}
