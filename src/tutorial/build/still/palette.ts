import type { Palette } from '../../../view/palette.ts'

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
