import { simulate } from '../../physics/index.ts'
import type { Timestep } from '../../physics/index.ts'
import { frameRateSpread, trajectoryErrors } from '../../measure/index.ts'
import { metres, seconds } from '../../chart/numbers.ts'
import { apart, kick, paperStep } from './experiments.ts'
import { exactly } from './fact.ts'
import type { Facts } from './fact.ts'

const step = 1 / 60

/** The kick with one frame of 0.25 s after 18 short ones. */
function hit(timestep: Timestep) {
  const short = (count: number) => Array.from({ length: count }, () => 1 / 60)
  const frames = { kind: 'recorded', durations: [...short(18), 0.25, ...short(60)] } as const
  return simulate({ ...kick, ...paperStep, timestep, frames, duration: 1.4 })
}

const offAfter = (timestep: Timestep) => Math.abs(trajectoryErrors(hit(timestep)).atEnd)
const fixed = { ...kick, ...paperStep, timestep: { kind: 'fixed', step } } as const

/** Unity's Update, as the figure on engines runs it. */
const unityUpdate = {
  ...{ ...kick, ...paperStep, duration: 1.5 },
  timestep: { kind: 'capped', cap: 1 / 3 },
} as const

/** What policies make of a hitch, what a fixed step costs, and what an engine makes of three players. */
export const realFrames = {
  hitchVariable: { value: () => offAfter({ kind: 'variable' }), show: metres },
  hitchSubsteps: { value: () => offAfter({ kind: 'substeps', step }), show: metres },
  hitchLost: { value: () => hit({ kind: 'capped', cap: 0.05 }).lostTime, show: seconds },
  fixedSpread: { value: () => frameRateSpread(fixed).distance, show: exactly(metres) },
  engineApart: { value: () => apart(unityUpdate, [20, 60, 144]), show: metres },
  fixedShort: { value: () => trajectoryErrors(simulate(fixed)).atEnd, show: metres },
} as const satisfies Facts
