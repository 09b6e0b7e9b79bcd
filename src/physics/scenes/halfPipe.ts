import type { NumberOption } from '../options.ts'
import { defineScene } from '../scene.ts'
import type { Parameters } from '../state.ts'
import { straight } from '../track.ts'
import { gravity, mass, muKinetic, muStatic, position, speed } from './parameters.ts'

const radius = {
  type: 'number',
  label: 'Radius',
  symbol: 'R',
  unit: 'm',
  min: 0.001,
  max: 1e6,
  slider: { from: 0.5, to: 5, step: 0.1 },
  initial: 2,
  optional: true,
} as const satisfies NumberOption

/** A block that swings in a half-pipe: a pendulum. */
export const halfPipe = defineScene({
  id: 'half-pipe',
  label: 'Half-pipe',
  about: 'To and fro between two walls: who gains energy, who loses it, and who is thrown out?',
  parameters: {
    radius,
    muStatic: { ...muStatic, initial: 0 },
    muKinetic: { ...muKinetic, initial: 0 },
    ...{ gravity, mass, position: { ...position, initial: 1.6 }, speed },
  },
  duration: 10,
  facing: 1,
  conflict: (parameters) =>
    Math.abs(parameters.position!) < lip(parameters)
      ? undefined
      : {
          parameter: 'position',
          problem: `is not inside the pipe, whose radius of ${parameters.radius!} m puts its lips at ±${Number(lip(parameters).toPrecision(5))} m`,
        },
  track: (parameters) => {
    const [from, to] = [-lip(parameters), lip(parameters)]
    return [{ ...straight(0), from, to, curvature: 1 / parameters.radius! }]
  },
})

/** The distance from the bottom to the lip, a quarter of a circle [m]. */
function lip({ radius }: Parameters): number {
  return (Math.PI / 2) * radius!
}
