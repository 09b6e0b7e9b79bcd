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
