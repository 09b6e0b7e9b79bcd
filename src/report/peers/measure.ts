import { createRun } from '../../physics/index.ts'
import { frameByFrame, ours } from '../contestants.ts'
import type { FrictionSeen, PeerRun, PeerTime } from '../schema.ts'
import { bytesOf } from '../timing/bytes.ts'
import { ratioOf, timeRounds, timingOf } from '../timing/rounds.ts'
import type { Care, Work } from '../timing/rounds.ts'
import { peers } from './index.ts'
import type { Block, Peer } from './peer.ts'
import { runOurs, runPeer } from './run.ts'
import { peerClocks, peerScenes } from './scenes.ts'
import { settled } from './settle.ts'

/** Frames of a run that is timed: two seconds at 60 fps. */
const FRAMES = 120
const FPS = 60
/** Runs at once, for a time and for a count of bytes. */
const TIMED = 50
const COUNTED = 2000

const slide = peerScenes[0]!

/** All scenes with our own two methods, under the clocks of these names. */
export function ourRuns(clocks: readonly string[]): PeerRun[] {
  return ours.flatMap(({ id: engine, method }) =>
    peerScenes.flatMap((scene) =>
      chosen(clocks).map(({ label: clock, frames }) => ({
        engine,
        scene: scene.id,
        clock,
        ...runOurs(method, scene, frames),
      })),
    ),
  )
}

/** The same with an engine, and the friction that it really has. */
export async function peerRuns(
  peer: Peer,
  clocks: readonly string[],
): Promise<{ runs: PeerRun[]; friction: FrictionSeen }> {
  const make = await peer.load()
  const runs = peerScenes.flatMap((scene) =>
    chosen(clocks).map(({ label: clock, frames }) => ({
      engine: peer.id,
      scene: scene.id,
      clock,
      ...runPeer(make, scene, frames),
    })),
  )
  const asked = 0.5
  const gravity = 9.81
  const block = settled(make, { angle: 0, friction: asked, gravity })
  const seen = frictionOf(block, gravity)
  block.free()
  return { runs, friction: { engine: peer.id, asked, seen } }
}

function chosen(clocks: readonly string[]): typeof peerClocks {
  return peerClocks.filter(({ label }) => clocks.includes(label))
}

/** The coefficient of friction with which a block brakes on the flat: six frames at 60 fps, from 6 m/s. */
export function frictionOf(block: Block, gravity: number): number {
  const frames = 6
  block.push(6)
  for (let i = 0; i < frames; i++) block.step(1 / FPS)
  return (6 - block.speed()) / ((frames / FPS) * gravity)
}

/** What a step of ours and of every engine costs: a block slides down 30°, two seconds at 60 fps and again from the start. */
export async function peerTimes(care: Care): Promise<PeerTime[]> {
  const { angle, muKinetic, gravity } = slide.parameters
  const slope = { angle: angle!, friction: muKinetic!, gravity: gravity! }
  const works = [
    { engine: ours[0].id as string, work: ourSteps(FPS, TIMED), counted: ourSteps(FPS, COUNTED) },
  ]
  for (const peer of peers) {
    const make = await peer.load()
    let block = settled(make, slope)
    const work: Work = {
      units: FRAMES,
      prepare: () => {
        block.free()
        block = settled(make, slope)
      },
      run: () => {
        for (let i = 0; i < FRAMES; i++) block.step(1 / FPS)
        return block.along()
      },
    }
    works.push({ engine: peer.id, work, counted: work })
  }
  const times = timeRounds(
    works.map(({ work }) => work),
    care,
  )
  return works.map(({ engine, counted }, i) => ({
    engine,
    step: timingOf(times[i]!),
    ratio: ratioOf(times[i]!, times[0]!),
    bytes: bytesOf(counted),
  }))
}

/** The same for ours called as a game calls it, in a process that does nothing else; its ratio is not known here. */
export function frameTime(care: Care): Omit<PeerTime, 'ratio'> {
  const [times] = timeRounds([ourSteps(1, TIMED)], care)
  return {
    engine: frameByFrame.id,
    step: timingOf(times!),
    bytes: bytesOf(ourSteps(1, COUNTED)),
  }
}

/** Ours, so many steps in a frame; many runs at once, since one is over before a clock ticks. */
function ourSteps(stepsInFrame: number, many: number): Work {
  const frames = FRAMES / stepsInFrame
  const start = () =>
    Array.from({ length: many }, () =>
      createRun({
        scene: 'ramp',
        parameters: slide.parameters,
        ...ours[0].method,
        timestep: stepsInFrame > 1 ? { kind: 'substeps', step: 1 / FPS } : { kind: 'variable' },
      }),
    )
  let runs = start()
  return {
    units: many * FRAMES,
    prepare: () => {
      runs = start()
    },
    run: () => {
      let sum = 0
      for (const run of runs) {
        for (let i = 0; i < frames; i++) run.frame(stepsInFrame / FPS)
        sum += run.motion.s
      }
      return sum
    },
  }
}
