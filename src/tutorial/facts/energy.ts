import { simulate } from '../../physics/index.ts'
import type { Experiment, IntegratorId } from '../../physics/index.ts'
import { mechanicalEnergy, stabilityLimit } from '../../measure/index.ts'
import { count, fixed, seconds } from '../../chart/numbers.ts'
import { percent } from './fact.ts'
import type { Facts } from './fact.ts'

const TEN_MINUTES = 600
const pipe: Experiment = {
  scene: 'half-pipe',
  parameters: { position: 2.2 },
  duration: TEN_MINUTES,
}

/** By how much the energy of a swing without friction strays at the most, as a part of what it was. */
function strays(experiment: Experiment): number {
  const energy = mechanicalEnergy(simulate(experiment))
  const start = energy[0]!
  return energy.reduce((most, value) => Math.max(most, Math.abs(value / start - 1)), 0)
}

const lost = (integrator: IntegratorId) => {
  const energy = mechanicalEnergy(simulate({ ...pipe, integrator }))
  return 1 - energy.at(-1)! / energy[0]!
}

/** The stiffest spring on 1 kg that a method with the limit ωΔt < 2 survives: k < m (2/Δt)² [N/m]. */
const stiffest = (fps: number) => (2 * fps) ** 2
const springs = (value: number) => `${count(value)}\u202fN/m`
const limit = (value: number) => fixed(value, 2)
/** “one part in 990 000”, with two digits. */
const onePartIn = (value: number) => `one part in ${count(Number((1 / value).toPrecision(2)))}`

/** Energy in the half-pipe, and the step that a spring bears. */
export const energy = {
  pipeSemi: { value: () => strays({ ...pipe, integrator: 'semi-implicit-euler' }), show: percent },
  pipeSemiSoon: {
    value: () => strays({ ...pipe, integrator: 'semi-implicit-euler', duration: 10 }),
    show: percent,
  },
  pipeVerlet: { value: () => strays({ ...pipe, integrator: 'velocity-verlet' }), show: percent },
  pipeRk4: { value: () => lost('rk4'), show: onePartIn },
  pipeJitter: {
    value: () =>
      strays({
        ...pipe,
        integrator: 'semi-implicit-euler',
        frames: { kind: 'jitter', fps: 60, amount: 0.9, seed: 1 },
      }),
    show: percent,
  },
  flungAfter: {
    value: () =>
      simulate({
        ...pipe,
        parameters: { position: 2.6 },
        integrator: 'explicit-euler',
      }).outcome.time,
    show: seconds,
  },
  limitSemi: { value: () => stabilityLimit('semi-implicit-euler'), show: limit },
  limitVerlet: { value: () => stabilityLimit('velocity-verlet'), show: limit },
  limitRk4: { value: () => stabilityLimit('rk4'), show: limit },
  stiffest60: { value: () => stiffest(60), show: springs },
  stiffest30: { value: () => stiffest(30), show: springs },
} as const satisfies Facts
