import { fall } from './fall.ts'
import { ramp } from './ramp.ts'
import { runOut } from './runOut.ts'
import { halfPipe } from './halfPipe.ts'
import { spring } from './spring.ts'

/** Every scene, from the plainest on. */
export const scenes = [fall, ramp, runOut, halfPipe, spring] as const

export type SceneId = (typeof scenes)[number]['id']
