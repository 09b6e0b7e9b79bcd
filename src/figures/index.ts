import type { Figure } from './shared/figure.ts'

/** A figure of the tutorial, and where to get it when it is needed. */
export interface FigureEntry {
  readonly id: string
  readonly load: () => Promise<Figure>
}

/** Every figure, in the order of the tutorial. They are loaded together, since they are much alike. */
export const figures: readonly FigureEntry[] = [
  'falling-ball',
  'forces-on-slope',
  'mass-cancels',
  'critical-angle',
  'two-become-one',
  'area-under-v',
  'where-does-it-stop',
  'chatter',
  'three-stops',
  'frames-and-ticks',
  'input-and-ticks',
  'hitch',
  'your-frames',
  'your-engine',
  'coasting',
  'following',
  'half-pipe-energy',
  'spring-limit',
  'flung-out',
  'speed-against-error',
  'step-to-tolerance',
  'paper-step',
  'break-it',
].map((id) => ({
  id,
  load: async () => {
    const { all } = await import('./all.ts')
    return all.find((each) => each.id === id)!
  },
}))
