import { box2d } from './box2d.ts'
import { matter } from './matter.ts'
import type { Peer } from './peer.ts'
import { planck } from './planck.ts'
import { rapier } from './rapier.ts'

/** What people would use instead. */
export const peers: readonly Peer[] = [matter, planck, rapier, box2d]

export type { Block, Peer, Slope } from './peer.ts'
