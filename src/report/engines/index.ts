import { box2d } from './box2d.ts'
import { matter } from './matter.ts'
import type { Engine } from './engine.ts'
import { planck } from './planck.ts'
import { rapier } from './rapier.ts'

/** What people would use instead. */
export const engines: readonly Engine[] = [matter, planck, rapier, box2d]

export type { Block, Engine, Slope } from './engine.ts'
