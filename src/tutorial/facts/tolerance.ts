import { simulate } from '../../physics/index.ts'
import type { Experiment } from '../../physics/index.ts'
import { count, metres, seconds } from '../../chart/numbers.ts'
import { roughSize } from '../../chart/magnitudes.ts'
import { apart } from './experiments.ts'
import type { Facts } from './fact.ts'

const pipe: Experiment = { scene: 'half-pipe', integrator: 'rk8' }
const nanometre: Experiment = { ...pipe, timestep: { kind: 'tolerance', tolerance: 1e-9 } }
const micrometre: Experiment = {
  ...pipe,
  integrator: 'rk4',
  timestep: { kind: 'tolerance', tolerance: 1e-6 },
}

/** Evaluations in a simulated second at 60 fps. */
function cost(experiment: Experiment): number {
  const { evaluations, experiment: whole } = simulate(experiment)
  return Math.round(evaluations / whole.duration)
}

/** From the top of a hill of 45° and 3 m, at 3 m/s, without friction. */
const TOP = (3 * Math.PI) / 4
const crest: Experiment = {
  scene: 'crest',
  parameters: {
    ...{ angle: 45, crestRadius: 3, muStatic: 0, muKinetic: 0, position: TOP, speed: 3 },
  },
  timestep: { kind: 'tolerance', tolerance: 1e-9 },
}

function takeOff(experiment: Experiment): { readonly s: number; readonly time: number } {
  const { outcome, s } = simulate(experiment)
  if (outcome.kind !== 'left-the-track') throw new Error('The text tells of a take-off.')
  return { s: s.at(-1)!, time: outcome.time }
}

function late(): number {
  const clamped = takeOff({
    ...crest,
    stopping: 'clamped',
    timestep: { kind: 'variable' },
    frames: { kind: 'steady', fps: 10 },
  })
  return clamped.time - takeOff(crest).time
}

/** What a tolerance costs and what it buys; where a hilltop lets go. */
export const tolerance = {
  toleranceCost: { value: () => cost(nanometre), show: count },
  toleranceSpread: { value: () => apart(nanometre), show: roughSize },
  toleranceStepSpread: { value: () => apart(pipe), show: metres },
  toleranceMicroSpread: { value: () => apart(micrometre), show: roughSize },
  toleranceMicroCost: { value: () => cost(micrometre), show: count },
  crestPlace: { value: () => takeOff(crest).s - TOP, show: metres },
  crestLate: { value: late, show: seconds },
} as const satisfies Facts
