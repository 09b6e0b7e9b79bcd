import type { Plugin } from 'vite'

/** Orders what a page's head asks for, and leaves out the addresses of a site that is not known when it is built. */
export function head(): Plugin {
  let published = true
  return {
    name: 'head',
    apply: 'build',
    configResolved: ({ env }) => void (published = env['VITE_SITE'] !== './'),
    transformIndexHtml: {
      order: 'post',
      handler: (html) => {
        // What is seen first, text and styles and fonts, before what makes it answer.
        const ordered = html.replace(/<(?:script type|link rel)="module(?:preload)?"/g, (start) => {
          return `${start} fetchpriority="low"`
        })
        if (published) return ordered
        return ordered.replace(/\s*<(?:link rel="canonical"|meta property="og:url")[^>]*>/g, '')
      },
    },
  }
}
