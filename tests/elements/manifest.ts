import { readFileSync } from 'node:fs'
import { join } from 'node:path'

/* The custom-elements manifest, made from the JSDoc blocks above the elements' classes. */

type Named = { name: string; description: string; type?: { text: string }; default?: string }
type Member = Named & { kind: 'field' | 'method'; readonly?: true }

type Declaration = {
  kind: 'class'
  name: string
  description: string
  superclass: { name: string; package: string }
  customElement: true
  tagName: string
  attributes: Named[]
  members: Member[]
  events: Named[]
  slots: Named[]
  cssParts: Named[]
  cssProperties: Named[]
}

/** As much of a manifest, schema version 2.1.0, as there is to say. */
export type Manifest = {
  schemaVersion: string
  readme: string
  modules: {
    kind: 'javascript-module'
    path: string
    declarations: Declaration[]
    exports: { kind: string; name: string; declaration: { name: string } }[]
  }[]
}

export const root = join(import.meta.dirname, '../..')

/** @throws Error for a tag that it does not know, or one without words */
export function makeManifest(): Manifest {
  const declarations = ['lab', 'figure'].map((file) =>
    declarationOf(readFileSync(join(root, `src/elements/${file}.ts`), 'utf8')),
  )
  return {
    schemaVersion: '2.1.0',
    readme: 'README.md',
    modules: [
      {
        kind: 'javascript-module',
        path: 'package/elements.js',
        declarations,
        exports: declarations.flatMap(({ name, tagName }) => [
          { kind: 'js', name, declaration: { name } },
          { kind: 'custom-element-definition', name: tagName, declaration: { name } },
        ]),
      },
    ],
  }
}

function declarationOf(source: string): Declaration {
  const [, block, name] = /\/\*\*((?:(?!\*\/)[^])*)\*\/\nexport class (\w+)/.exec(source)!
  const [description, ...tags] = block!.replace(/^ ?\* ?/gm, '').split(/^@/m)
  const found = tags.map(tagOf)
  const of = (tag: string) => found.flatMap((each) => (each.tag === tag ? each.all : []))
  const known = ['tag', 'attr', 'prop', 'readonly', 'method', 'fires', 'slot', 'csspart', 'cssprop']
  const strange = found.find(({ tag }) => !known.includes(tag))
  if (strange) throw new Error(`@${strange.tag} is not known.`)
  return {
    kind: 'class',
    name: name!,
    description: plain(description!),
    superclass: { name: 'LitElement', package: 'lit' },
    customElement: true,
    tagName: of('tag')[0]!.name,
    attributes: of('attr'),
    members: [
      ...of('prop').map((each) => ({ kind: 'field' as const, ...each })),
      ...of('readonly').map((each) => ({
        kind: 'field' as const,
        ...each,
        readonly: true as const,
      })),
      ...of('method').map((each) => ({ kind: 'method' as const, ...each })),
    ],
    events: of('fires'),
    slots: of('slot'),
    cssParts: of('csspart'),
    cssProperties: of('cssprop'),
  }
}

/** `tag {type} name, other - description`; a slot may have no name, a property that is like its attribute no words. */
function tagOf(text: string): { tag: string; all: Named[] } {
  const match = /^(\w+)(?: \{([^]*?)\}(?= [\w-]))?(?: ((?:[\w-]+, )*[\w-]+))?(?: - ([^]*))?$/.exec(
    plain(text),
  )
  if (!match) throw new Error(`This can't be read: @${text}`)
  const [, tag, type, names = '', description = ''] = match
  return {
    tag: tag!,
    all: names.split(', ').map((name) => ({
      name,
      ...(type !== undefined && { type: { text: type } }),
      description: tag === 'prop' && !description ? `The attribute ${name}.` : description,
    })),
  }
}

function plain(text: string): string {
  return text.replace(/\s+/g, ' ').trim()
}
