import { exactTrack } from '../exact/track.ts'
import type { Contact, Law } from '../law.ts'
import type { NumberOption, Values } from '../options.ts'
import type { Scene } from '../scene.ts'
import { placeOn } from '../track.ts'
import type { Track } from '../track.ts'
import { SinCos, sinCos } from '../trigonometry.ts'
import { rubbing } from './law.ts'
import * as shared from './parameters.ts'

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

const parameters = {
  radius,
  muStatic: { ...shared.muStatic, initial: 0 },
  muKinetic: { ...shared.muKinetic, initial: 0 },
  gravity: shared.gravity,
  mass: shared.mass,
  position: { ...shared.position, initial: 1.6 },
  speed: shared.speed,
} as const
type HalfPipeParameters = Values<typeof parameters>

/** To and fro in a pipe: a pendulum. */
export const halfPipe = {
  id: 'half-pipe',
  label: 'Half-pipe',
  about:
    'To and fro between two walls: who gains energy, who loses it, and who is thrown out of the pipe?',
  parameters,
  duration: 10,
  facing: 1,
  conflict: ({ radius, position }: HalfPipeParameters) =>
    Math.abs(position) < lip(radius)
      ? undefined
      : {
          parameter: 'position',
          problem: `is not inside the pipe, whose radius of ${radius} m puts its lips at ±${Number(lip(radius).toPrecision(5))} m`,
        },
  law: ({ radius, gravity, mass, muStatic, muKinetic }: HalfPipeParameters): Law => {
    const direction = new SinCos()
    // #region forces
    const pipe = (block: Contact) => {
      direction.angle = block.s / radius
      direction.find()
      block.drive = -gravity * direction.sin
      block.press = gravity * direction.cos + (block.v * block.v) / radius
    }
    // #endregion
    return {
      ...rubbing(mass, muStatic, muKinetic),
      // Beyond the lips there is no track; a step that ends there has felt the pipe's forces.
      forces: [pipe, pipe, pipe],
      dependsOnSpeed: muKinetic > 0,
      joints: [-lip(radius), lip(radius)],
      open: true,
    }
  },
  place: ({ radius }: HalfPipeParameters, s: number) => placeOn(track(radius), s),
  potential: ({ radius, gravity }: HalfPipeParameters, s: number) => {
    // 1 − cos θ = 2 sin² θ/2, without the cancellation near the bottom.
    const { sin } = sinCos(s / radius / 2)
    return 2 * gravity * radius * sin * sin
  },
  exact: (parameters: HalfPipeParameters) => exactTrack(track(parameters.radius), parameters),
} as const satisfies Scene

/** The distance from the bottom to the lip, a quarter of a circle [m]. */
function lip(radius: number): number {
  return (Math.PI / 2) * radius
}

function track(radius: number): Track {
  const bottom = { at: 0, x: 0, y: 0, slope: 0, sin: 0, cos: 1 }
  return [{ ...bottom, from: -lip(radius), to: lip(radius), curvature: 1 / radius }]
}
