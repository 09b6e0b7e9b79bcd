import { handwritten, looping } from './handwritten/index.ts'
import type { Handwritten } from './handwritten/index.ts'
import type { FrameTime, Timing } from './schema/index.ts'
import { bytesOf } from './timing/bytes.ts'
import { ratioOf, timeRounds, timingOf } from './timing/rounds.ts'
import type { Care } from './timing/rounds.ts'
import { timed, trial } from './timing/trials.ts'
import { framing, runEverything } from './timing/works.ts'

/**
 * What one process finds out about a scene and a method: beside the handwritten loop, alone or after everything else.
 */
export interface LoopTimes {
  scene: string
  integrator: string
  handwritten: Timing
  ours: Timing
  ratio: number
  bytes: number
}

/** A young generation of 64 MB holds what a million steps allocate, at a number or two each. */
const COUNTED_RUNS = 100

/** Times one scene with one method, in a process that does nothing else. */
export function timeAlone(scene: string, integrator: string, care: Care): LoopTimes[] {
  return timeLoops(
    handwritten.filter((loop) => loop.scene === scene && loop.integrator === integrator),
    care,
  )
}

/** Times every handwritten loop of these methods, in a process whose call sites have seen everything. */
export function timeMixed(methods: readonly string[], care: Care): LoopTimes[] {
  runEverything()
  return timeLoops(
    handwritten.filter(({ integrator }) => methods.includes(integrator)),
    care,
  )
}

function timeLoops(loops: readonly Handwritten[], care: Care): LoopTimes[] {
  const works = loops.flatMap(({ scene, integrator, start }) => {
    const experiment = trial(scene, integrator)
    return [looping(() => start(experiment.parameters), timed), framing(experiment, timed)]
  })
  const times = timeRounds(works, care)
  return loops.map(({ scene, integrator }, i) => {
    const [loop, ours] = times.slice(2 * i, 2 * i + 2) as [number[], number[]]
    const counted = framing(trial(scene, integrator), { ...timed, runs: COUNTED_RUNS })
    return {
      scene,
      integrator,
      handwritten: timingOf(loop),
      ours: timingOf(ours),
      ratio: ratioOf(ours, loop),
      bytes: bytesOf(counted),
    }
  })
}

/** Puts together what the two kinds of process found. */
export function frameTimes(alone: readonly LoopTimes[], mixed: readonly LoopTimes[]): FrameTime[] {
  return alone.map(({ scene, integrator, handwritten, ours, ratio, bytes }) => {
    const other = mixed.find((row) => row.scene === scene && row.integrator === integrator)
    return {
      scene,
      integrator,
      handwritten,
      alone: ours,
      mixed: other?.ours ?? null,
      ratios: { alone: ratio, mixed: other?.ratio ?? null },
      bytes: { alone: bytes, mixed: other?.bytes ?? null },
    }
  })
}
