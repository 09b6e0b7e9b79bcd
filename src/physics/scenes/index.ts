import { fall } from './fall.ts'
import { ramp } from './ramp.ts'
import { runOut } from './runOut.ts'
import { halfPipe } from './halfPipe.ts'
import { spring } from './spring.ts'
import { crest } from './crest.ts'
import { belt } from './belt.ts'

/** Every scene, the simplest first. */
export const scenes = [fall, ramp, runOut, halfPipe, spring, crest, belt] as const

export type SceneId = (typeof scenes)[number]['id']
