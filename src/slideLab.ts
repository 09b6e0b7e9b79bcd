/* The elements as one file for `<script type="module" src="…/slide-lab.js"></script>`. */
import { findSite, published } from './lab/site.ts'

export * from './elements.ts'

// The file may lie beside the lab that it was built with, or have been copied to where there is no lab.
if (!published) findSite(besideThisFile)

/**
 * The folder that this file is in, if the lab is there too; else null. What it asks for is a module, which any page may
 * load that could load this one.
 */
async function besideThisFile(): Promise<string | null> {
  const folder = import.meta.url.replace(/[^/]*$/, '')
  try {
    const mark = (await import(/* @vite-ignore */ `${folder}lab.js`)) as { default?: unknown }
    return mark.default === 'any-frame-rate' ? folder : null
  } catch {
    return null
  }
}
