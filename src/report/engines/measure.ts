import { byHand, ours, recorded, engines } from './index.ts'
import { looping } from '../handwritten/index.ts'
import { RampVerlet } from '../handwritten/rampVerlet.ts'
import type { FrictionSeen, EngineRun, EngineTime } from '../schema/index.ts'
import { bytesOf } from '../timing/bytes.ts'
import { ratioOf, timeRounds, timingOf } from '../timing/rounds.ts'
import type { Care, TimedWork } from '../timing/rounds.ts'
import { timed, trial } from '../timing/trials.ts'
import { framing, simulating } from '../timing/works.ts'
import type { Amount } from '../timing/works.ts'
import type { EngineBlock, Engine } from './engine.ts'
import { runOurs, runEngine } from './run.ts'
import { engineClocks, engineScenes } from './scenes.ts'
import { settled } from './engine.ts'

/** Frames of a run that is timed: two seconds at 60 fps. */
const FRAMES = 120
const FPS = 60
/** Runs at once, for a time and for a count of bytes: one of ours is over before a clock ticks. */
const TIMED: Amount = { runs: 50, steps: FRAMES, step: 1 / FPS }
const COUNTED: Amount = { ...TIMED, runs: 2000 }

const slide = engineScenes[0]!

/** All scenes with our own two methods, under the clocks of these names. */
export function ourRuns(clocks: readonly string[]): EngineRun[] {
  return ours.flatMap(({ id: engine, method }) =>
    engineScenes.flatMap((scene) =>
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
export async function engineRuns(
  engine: Engine,
  clocks: readonly string[],
): Promise<{ runs: EngineRun[]; friction: FrictionSeen }> {
  const make = await engine.load()
  const runs = engineScenes.flatMap((scene) =>
    chosen(clocks).map(({ label: clock, frames }) => ({
      engine: engine.id,
      scene: scene.id,
      clock,
      ...runEngine(make, scene, frames),
    })),
  )
  const asked = 0.5
  const gravity = 9.81
  const block = settled(make, { angle: 0, friction: asked, gravity })
  const seen = frictionOf(block, gravity)
  block.free()
  return { runs, friction: { engine: engine.id, asked, seen } }
}

function chosen(clocks: readonly string[]): typeof engineClocks {
  return engineClocks.filter(({ label }) => clocks.includes(label))
}

/** The coefficient of friction with which a block brakes on the flat: six frames at 60 fps, from 6 m/s. */
export function frictionOf(block: EngineBlock, gravity: number): number {
  const frames = 6
  block.push(6)
  for (let i = 0; i < frames; i++) block.step(1 / FPS)
  return (6 - block.speed()) / ((frames / FPS) * gravity)
}

/** What a step costs, a call for each: a block slides down 30°, two seconds at 60 fps and again from the start. */
export async function engineTimes(care: Care): Promise<EngineTime[]> {
  const { angle, muKinetic, gravity } = slide.parameters
  const slope = { angle: angle!, friction: muKinetic!, gravity: gravity! }
  const experiment = { scene: 'ramp', parameters: slide.parameters, ...ours[0].method } as const
  const byHandOf = (amount: Amount) => looping(() => new RampVerlet(slide.parameters), amount)
  const works: { engine: string; work: TimedWork; counted: TimedWork }[] = [
    {
      engine: ours[0].id,
      work: framing(experiment, TIMED),
      counted: framing(experiment, COUNTED),
    },
    { engine: byHand.id, work: byHandOf(TIMED), counted: byHandOf(COUNTED) },
  ]
  for (const engine of engines) {
    const make = await engine.load()
    let block = settled(make, slope)
    const work: TimedWork = {
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
    works.push({ engine: engine.id, work, counted: work })
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

/** The same for `simulate`, in a process that does nothing else; its ratio is not known here. */
export function simulateTime(care: Care): Omit<EngineTime, 'ratio'> {
  const work = simulating(trial('ramp', 'velocity-verlet'), timed.steps)
  const [times] = timeRounds([work], care)
  return { engine: recorded.id, step: timingOf(times!), bytes: bytesOf(work) }
}
