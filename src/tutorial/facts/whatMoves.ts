import { exact } from '../../physics/index.ts'
import type { Experiment } from '../../physics/index.ts'
import { metres } from '../../chart/numbers.ts'
import { at, end } from './experiments.ts'
import type { Facts } from './fact.ts'

const fall: Experiment = { scene: 'fall', integrator: 'semi-implicit-euler', duration: 1 }
const truth = () => exact(fall, 1).s
const perFrame: Experiment = { ...fall, timestep: { kind: 'per-frame', step: 1 / 60 } }

/** A ball that falls for a second. */
export const whatMoves = {
  fallTrue: { value: truth, show: metres },
  fallPerFrame15: { value: () => end(at(15, perFrame)), show: metres },
  fallPerFrame120: { value: () => end(at(120, perFrame)), show: metres },
  fallAhead60: { value: () => end(at(60, fall)) - truth(), show: metres },
  fallAhead10: { value: () => end(at(10, fall)) - truth(), show: metres },
} as const satisfies Facts
