import { clamp } from '../chart/geometry.ts'
import type { ArrowId } from './picture.ts'

/** The colours and typefaces of a picture, from the page's custom properties. */
export interface Palette {
  readonly ink: string
  readonly inkSoft: string
  readonly paper: string
  readonly sheet: string
  readonly ground: string
  readonly line: string
  /** Of what must be seen: 3:1. */
  readonly edge: string
  readonly wrong: string
  readonly accent: string
  readonly accentText: string
  /** By look, 0 … 7: to fill with, and to write with. */
  readonly runners: readonly { readonly fill: string; readonly text: string }[]
  /** Of the arrows on a block. */
  readonly arrows: Readonly<Record<ArrowId, string>>
  readonly sans: string
  readonly serif: string
}

/** Red, green and blue, 0 … 255. */
export type Rgb = readonly [number, number, number]

/** What text needs against what it stands on. */
const TEXT_CONTRAST = 4.5

/** Reads the palette of an element, and again when the page's theme has changed it. */
export class PaletteReader {
  private readonly style: CSSStyleDeclaration
  private key = ''
  private palette: Palette | undefined

  constructor(element: Element) {
    // Alive: it follows every change of the page's styles.
    this.style = getComputedStyle(element)
  }

  read(): Palette {
    // “CanvasText” stays what it is when the system's colours change; the colour of text does not.
    const key = ['color', '--ink', '--sheet', '--accent', '--sans']
      .map((name) => this.get(name))
      .join()
    if (!this.palette || key !== this.key) {
      this.key = key
      this.palette = this.readAll()
    }
    return this.palette
  }

  private get(name: string): string {
    return this.style.getPropertyValue(name).trim()
  }

  private readAll(): Palette {
    const toRgb = colourParser()
    const colour = (name: string, fallback: string) => this.get(name) || fallback
    const ink = colour('--ink', '#1d2127')
    const sheet = colour('--sheet', '#ffffff')
    const accent = colour('--accent', '#0a5cc5')
    const legible = (value: string) => css(readable(toRgb(value), toRgb(sheet), toRgb(ink)))
    // The page's colours suit the page's sheet. On the system's they are moved as far as they must be to be seen.
    const isForced = this.get('--forced-colors') === 'active'
    const seen = (name: string, fallback: string) =>
      isForced ? legible(colour(name, fallback)) : colour(name, fallback)
    return {
      ink,
      sheet,
      accent,
      accentText: legible(accent),
      inkSoft: colour('--ink-soft', '#5c6370'),
      paper: colour('--paper', '#fbfaf6'),
      ground: colour('--ground', '#eeece4'),
      line: isForced ? css(mix(toRgb(sheet), toRgb(ink), 0.3)) : colour('--line', '#dfddd4'),
      edge: colour('--edge', '#8d9097'),
      wrong: seen('--wrong', '#b3261e'),
      runners: okabeIto.map((fallback, i) => {
        const fill = seen(`--runner-${i}`, fallback)
        return { fill, text: legible(fill) }
      }),
      arrows: {
        gravity: seen('--force-gravity', ink),
        normal: seen('--force-normal', ink),
        friction: seen('--force-friction', ink),
        other: seen('--force-other', ink),
        sum: seen('--force-sum', ink),
        velocity: seen('--velocity', ink),
      },
      sans: this.get('--sans') || 'system-ui, sans-serif',
      serif: this.get('--serif') || 'Georgia, serif',
    }
  }
}

/** For a page that says nothing. */
const okabeIto = [
  ...['#d55e00', '#0072b2', '#009e73', '#cc79a7'],
  ...['#e69f00', '#56b4e9', '#7a6a00', '#5c4b8a'],
]

/** A colour as near to the given one as can be read on a background: mixed with ink until its contrast suffices. */
export function readable(colour: Rgb, background: Rgb, ink: Rgb): Rgb {
  for (let part = 0; part < 1; part += 0.05) {
    const mixed = mix(colour, ink, part)
    if (contrast(mixed, background) >= TEXT_CONTRAST) return mixed
  }
  return ink
}

/** The contrast of two colours as WCAG defines it, 1 … 21. */
export function contrast(a: Rgb, b: Rgb): number {
  const [low, high] = [luminance(a), luminance(b)].sort((p, q) => p - q) as [number, number]
  return (high + 0.05) / (low + 0.05)
}

function luminance(colour: Rgb): number {
  const [r, g, b] = colour.map((value) => {
    const part = value / 255
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4
  }) as [number, number, number]
  return 0.2126 * r + 0.7152 * g + 0.0722 * b
}

/** The colour at a part of the way from one to the other, 0 … 1. */
export function mix(a: Rgb, b: Rgb, part: number): Rgb {
  const at = (i: 0 | 1 | 2) => Math.round(clamp(a[i] + part * (b[i] - a[i]), 0, 255))
  return [at(0), at(1), at(2)]
}

function css([r, g, b]: Rgb): string {
  return `rgb(${r} ${g} ${b})`
}

/** Lets the browser itself say what a colour is, in whichever notation the page has it. */
function colourParser(): (colour: string) => Rgb {
  const canvas = document.createElement('canvas')
  canvas.width = canvas.height = 1
  const context = canvas.getContext('2d', { willReadFrequently: true })!
  return (colour) => {
    context.fillStyle = colour
    context.fillRect(0, 0, 1, 1)
    const [r, g, b] = context.getImageData(0, 0, 1, 1).data
    return [r!, g!, b!]
  }
}
