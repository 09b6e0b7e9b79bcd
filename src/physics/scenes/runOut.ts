import { exactTrack } from '../exact/track.ts'
import type { Contact, Law } from '../law.ts'
import type { NumberOption, Values } from '../options.ts'
import type { Scene } from '../scene.ts'
import { placeOn, straight } from '../track.ts'
import type { Track } from '../track.ts'
import { SinCos, radians } from '../trigonometry.ts'
import { rubbing } from './law.ts'
import { angle, gravity, mass, muKinetic, muStatic, position, speed } from './parameters.ts'

const length = {
  type: 'number',
  label: 'Length of the slope',
  symbol: 'L',
  unit: 'm',
  min: 0,
  max: 1e6,
  slider: { from: 0, to: 10, step: 0.1 },
  initial: 4,
  optional: true,
} as const satisfies NumberOption

const bendRadius = {
  type: 'number',
  label: 'Radius of the bend',
  symbol: 'R',
  unit: 'm',
  min: 0.001,
  max: 1e6,
  slider: { from: 0.2, to: 5, step: 0.1 },
  initial: 1.5,
  optional: true,
} as const satisfies NumberOption

const parameters = {
  angle,
  length,
  bendRadius,
  muStatic,
  muKinetic,
  gravity,
  mass,
  position,
  speed,
} as const
type RunOutParameters = Values<typeof parameters>

/** Down a hill, round a bend and out on the flat. */
export const runOut = {
  id: 'run-out',
  label: 'Run-out',
  about:
    'Down a hill, round a bend and out on the flat: where does it stop? The law changes at both ends of the bend.',
  parameters,
  duration: 4,
  facing: 1,
  law: (parameters: RunOutParameters): Law => {
    const { gravity, mass, muStatic, muKinetic } = parameters
    const [slope, bend] = track(parameters)
    const direction = new SinCos()
    return {
      ...rubbing(mass, muStatic, muKinetic),
      forces: [
        { drive: gravity * slope.sin, press: gravity * slope.cos },
        (block: Contact) => {
          direction.angle = bend.slope - bend.curvature * (block.s - bend.at)
          direction.find()
          block.drive = gravity * direction.sin
          block.press = gravity * direction.cos + block.v * block.v * bend.curvature
        },
        { drive: 0, press: gravity },
      ],
      dependsOnSpeed: muKinetic > 0,
      turnMatters: true,
      joints: [bend.from, bend.to],
    }
  },
  place: (parameters: RunOutParameters, s: number) => placeOn(track(parameters), s),
  potential: (parameters: RunOutParameters, s: number) =>
    parameters.gravity * placeOn(track(parameters), s).y,
  exact: (parameters: RunOutParameters) => exactTrack(track(parameters), parameters),
} as const satisfies Scene

let latest: { angle: number; length: number; bendRadius: number; track: RunOutTrack } | undefined

/** The track, laid out anew only where it is another than last: a picture asks for hundreds of its points. */
function track({ angle, length, bendRadius }: RunOutParameters): RunOutTrack {
  if (latest?.angle !== angle || latest.length !== length || latest.bendRadius !== bendRadius)
    latest = { angle, length, bendRadius, track: layOut(angle, length, bendRadius) }
  return latest.track
}

type RunOutTrack = ReturnType<typeof layOut>

function layOut(angle: number, length: number, bendRadius: number) {
  const slope = straight(angle, length)
  const top = placeOn([slope], length)
  const end = length + bendRadius * radians(angle)
  const bend = { ...slope, ...top, from: length, to: end, at: length, curvature: 1 / bendRadius }
  const foot = placeOn([bend], end)
  const flat = {
    from: end,
    to: Infinity,
    at: end,
    x: foot.x,
    y: foot.y,
    slope: 0,
    sin: 0,
    cos: 1,
    curvature: 0,
  }
  return [slope, bend, flat] as const satisfies Track
}
