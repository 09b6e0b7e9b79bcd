import type { LitElement } from 'lit'
import { PaletteReader } from '../../view/palette.ts'
import { onThemeChange } from '../../ui/theme.ts'
import type { MapCells } from './mapCells.ts'
import { paintMap } from './mapImage.ts'

/** An element with a map in its canvas. */
interface Host extends LitElement {
  readonly cells: MapCells
}

/** Keeps the map of an element painted: again whenever its cells or the page's colours are others. */
export function keepPainted(host: Host): void {
  const colours = new PaletteReader(host)
  /** What the image was painted from. */
  let painted: unknown[] = []
  let stopThemes = () => {}
  host.addController({
    hostConnected: () => {
      stopThemes = onThemeChange(() => host.requestUpdate())
    },
    hostDisconnected: () => stopThemes(),
    hostUpdated: () => {
      const { cells } = host
      const palette = colours.read()
      const wanted = [cells, cells.version, palette]
      if (wanted.every((each, i) => each === painted[i])) return
      painted = wanted
      paintMap(host.querySelector('canvas')!, cells, palette, isDark(host))
    },
  })
}

/** Whether an element is seen on a dark page. */
export function isDark(element: Element): boolean {
  return getComputedStyle(element).colorScheme === 'dark'
}
