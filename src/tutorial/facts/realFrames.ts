import { simulate } from '../../physics/index.ts'
import type { Timestep } from '../../physics/index.ts'
import { frameRateSpread, trajectoryErrors } from '../../measure/index.ts'
import { fixed as decimals, metres, seconds } from '../../chart/numbers.ts'
import { readPresses } from '../../physics/input.ts'
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

/** The part of all presses that are heard of by so many ticks, 50 a second, at a steady frame rate. */
function heard(fps: number, isSuch: (ticks: number) => boolean): number {
  // Half a second more, in which the last of them are taken. None of 6000 evenly spread presses falls on a frame's end.
  const ends = Array.from({ length: 1.5 * fps }, (_, i) => (i + 1) / fps)
  const times = Array.from({ length: 6000 }, (_, i) => (i + 0.5) / 6000)
  const presses = readPresses(ends, 1 / 50, times)
  return presses.filter(({ counted }) => isSuch(counted.length)).length / times.length
}

const percent = (part: number) => `${decimals(100 * part, 0)}\u202f%`

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
  pressesLost: { value: () => heard(60, (ticks) => ticks === 0), show: percent },
  pressesTwice: { value: () => heard(30, (ticks) => ticks === 2), show: percent },
  engineApart: { value: () => apart(unityUpdate, [20, 60, 144]), show: metres },
  fixedShort: { value: () => trajectoryErrors(simulate(fixed)).atEnd, show: metres },
} as const satisfies Facts
