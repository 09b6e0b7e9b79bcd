import type { Palette } from '../../view/palette.ts'

/** How much of a runner's colour a word in it keeps; the rest is ink. So it can be read in both themes. */
export const TEXT_SHARE = 70

/** The page's colours by name, not by value: a still has those of the theme that it is looked at in. */
export const stillPalette: Palette = {
  ink: 'var(--ink)',
  inkSoft: 'var(--ink-soft)',
  paper: 'var(--paper)',
  sheet: 'var(--sheet)',
  ground: 'var(--ground)',
  line: 'var(--line)',
  edge: 'var(--edge)',
  wrong: 'var(--wrong)',
  accent: 'var(--accent)',
  accentText: 'var(--accent)',
  runners: Array.from({ length: 8 }, (_, i) => ({
    fill: `var(--runner-${i})`,
    text: `color-mix(in srgb, var(--runner-${i}) ${TEXT_SHARE}%, var(--ink))`,
  })),
  arrows: {
    gravity: 'var(--force-gravity)',
    normal: 'var(--force-normal)',
    friction: 'var(--force-friction)',
    other: 'var(--force-other)',
    sum: 'var(--force-sum)',
    velocity: 'var(--velocity)',
  },
  sans: 'var(--sans)',
  serif: 'var(--serif)',
}

/*
 * The stage asks its canvas which red, green and blue a colour has, to darken it until it can be read. A still has no
 * values, only names. So a colour's answer is a number for its name, dark enough to be left as it is, and what the stage
 * makes of it is turned back into the name of the colour to write with.
 */

const names = [...stillPalette.runners.map(({ fill }) => fill), stillPalette.accent]
const texts = [...stillPalette.runners.map(({ text }) => text), stillPalette.accentText]

/** Red, green, blue and alpha for the name of a colour. */
export function encoded(colour: string): [number, number, number, number] {
  const index = names.indexOf(colour)
  if (colour === stillPalette.sheet) return [255, 255, 255, 255]
  return [0, 0, index + 1, 255]
}

/** The name of the colour to write with where it was made of such a code; any other colour is itself. */
export function decoded(colour: string): string {
  const code = /^rgb\(0 0 (\d+)\)$/.exec(colour)?.[1]
  return code === undefined ? colour : (texts[Number(code) - 1] ?? stillPalette.ink)
}
