import { exactFall } from '../exact/fall.ts'
import type { Law } from '../law.ts'
import type { NumberOption, Values } from '../options.ts'
import type { Place, Scene } from '../scene.ts'
import { freely } from './law.ts'
import { gravity, mass, position, speed } from './parameters.ts'

const drag = {
  type: 'number',
  label: 'Drag',
  symbol: 'c',
  unit: 'kg/m',
  min: 0,
  max: 1e6,
  slider: { from: 0, to: 2, step: 0.01 },
  initial: 0,
  optional: true,
} as const satisfies NumberOption

const parameters = { gravity, mass, drag, position, speed } as const
type FallParameters = Values<typeof parameters>

/** The paper's ball: it falls, with the drag of air if there is any. */
export const fall = {
  id: 'fall',
  label: 'Fall',
  about:
    'A ball falls. The simplest motion there is, and with drag one whose force depends on the speed.',
  parameters,
  duration: 2,
  facing: 1,
  law: ({ gravity, mass, drag }: FallParameters): Law => ({
    ...freely(mass),
    forces: [{ drive: gravity, perSquare: drag / mass, press: 0 }],
    dependsOnSpeed: drag > 0,
    // v|v| has a kink at v = 0.
    turnMatters: drag > 0,
  }),
  place: (_: FallParameters, s: number): Place => ({
    x: 0,
    y: -s,
    slope: Math.PI / 2,
    curvature: 0,
  }),
  potential: ({ gravity }: FallParameters, s: number) => -gravity * s,
  exact: exactFall,
} as const satisfies Scene
