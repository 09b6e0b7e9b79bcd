import { describe, expect, it } from 'vitest'
import { exact, integrators, scenes, simulate } from '../../src/physics/index.ts'
import type { Experiment, FramesChoice, Scene, SceneId } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { Chance } from './generated.ts'
import { last } from './truth.ts'

const ranges: Record<string, [number, number]> = {
  gravity: [1, 20],
  mass: [0.5, 3],
  drag: [0, 1],
  angle: [0, 60],
  muStatic: [0, 0.8],
  muKinetic: [0, 0.5],
  length: [0.2, 4],
  bendRadius: [0.3, 3],
  radius: [1, 3],
  crestRadius: [0.5, 5],
  beltSpeed: [-1.5, 1.5],
  stiffness: [5, 200],
  position: [-1.4, 1.4],
  speed: [-6, 6],
}

/** Experiments in all scenes in turn, one in five from rest, one in five without friction; 1 … 3 s. */
function experiments(count: number, seed: number): Experiment[] {
  const chance = new Chance(seed)
  const list: Experiment[] = []
  while (list.length < count) {
    const scene: Scene = scenes[list.length % scenes.length]!
    const names = Object.keys(scene.parameters)
    const given = Object.fromEntries(names.map((name) => [name, chance.between(...ranges[name]!)]))
    if (chance.share(0.2)) given.speed = 0
    if ('muStatic' in given) {
      if (chance.share(0.2)) given.muStatic = given.muKinetic = 0
      given.muStatic = Math.max(given.muStatic!, given.muKinetic!)
    }
    const duration = chance.between(1, 3)
    const experiment = { scene: scene.id as SceneId, parameters: given, duration }
    if (!scene.conflict?.(given) && isWellConditioned(experiment)) list.push(experiment)
  }
  return list
}

/** A change of where and how fast it starts changes where it ends by ten times as much at the most. */
function isWellConditioned({ duration = 0, ...experiment }: Experiment): boolean {
  const change = 1e-7
  const { s } = exact(experiment, duration)
  return (['position', 'speed'] as const).every((name) => {
    const parameters = { ...experiment.parameters, [name]: experiment.parameters![name]! + change }
    return Math.abs(exact({ ...experiment, parameters }, duration).s - s) <= 10 * change
  })
}

const clocks: readonly FramesChoice[] = [
  { kind: 'steady', fps: 5 },
  { kind: 'steady', fps: 24 },
  { kind: 'steady', fps: 240 },
  { kind: 'jitter', fps: 60, amount: 0.9, seed: 7 },
  { kind: 'hitch', fps: 60, every: 0.7, length: 0.5 },
]

/** Where an experiment ends with each clock: largest less smallest [m]. */
function spread(experiment: Experiment): number {
  const ends = clocks.map((frames) => last(simulate({ ...experiment, frames }).s))
  return Math.max(...ends) - Math.min(...ends)
}

const methods = ['velocity-verlet', 'rk4', 'rk8'] as const
const GROUPS = 10

describe('to a tolerance of 1e-9 m a second, with stops located', () => {
  // Seven scenes and three methods in turn: each scene meets each method.
  const all = experiments(samples(42, 300), 20261128).map((experiment, i) => ({
    ...experiment,
    integrator: methods[i % methods.length]!,
    timestep: { kind: 'tolerance', tolerance: 1e-9 } as const,
  }))
  const groups = Array.from({ length: GROUPS }, (_, group) => group)

  it.each(groups)(
    'a block ends within 1e-8 m at any frame rate, in every scene: group %d',
    (group) => {
      // Three seconds of it, at a condition of ten: never all at once.
      for (const experiment of all.filter((_, i) => i % GROUPS === group))
        expect(spread(experiment), JSON.stringify(experiment)).toBeLessThanOrEqual(1e-8)
    },
  )
})

describe.each(scenes)('$id', ({ id: scene }) => {
  it('spreads by at most ten times the tolerance, whatever that is', () => {
    for (const { id: integrator } of integrators.filter(({ order }) => order >= 2))
      for (const tolerance of [1e-3, 1e-5, 1e-7]) {
        const duration = 1
        const timestep = { kind: 'tolerance', tolerance } as const
        expect(spread({ scene, integrator, timestep, duration }), integrator).toBeLessThanOrEqual(
          10 * tolerance,
        )
      }
  })
})

describe('a try shares no part with what it is compared with', () => {
  // So near to an event, the frame's first step ends almost before it has begun, and the next one is all the rest.
  const before = [0, 1e-18, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3]
  const onto = { angle: 40, length: 0.5, bendRadius: 2, muStatic: 0.3, muKinetic: 0.3 }
  const over = { angle: 1, crestRadius: 2, muStatic: 0.3, muKinetic: 0.13, speed: 0.6 }
  const starts: Record<string, (distance: number) => Experiment> = {
    'a bend': (distance) => ({
      ...{ scene: 'run-out', parameters: { ...onto, position: 0.5 - distance, speed: 1 } },
    }),
    'a crest': (distance) => ({ scene: 'crest', parameters: { ...over, position: -distance } }),
    'a turn on a slope, and then a bend': (distance) => ({
      ...{ scene: 'run-out', parameters: { ...onto, position: 0.45, speed: -distance } },
    }),
    'a turn in a half-pipe': (distance) => ({
      ...{ scene: 'half-pipe', parameters: { position: 1.5, speed: distance } },
    }),
    'a turn on a spring': (distance) => ({
      ...{ scene: 'spring', parameters: { position: 1.5, speed: distance } },
    }),
    'a slip on a belt': (distance) => ({
      ...{ scene: 'belt', parameters: { position: -1, speed: 0.5 - distance } },
    }),
  }

  it.each(Object.entries(starts))('just before %s', (_, start) => {
    const tolerance = 1e-8
    for (const integrator of methods)
      for (const distance of before) {
        const given = { ...start(distance), integrator, duration: 0.8 } as const
        const frames = { kind: 'steady', fps: 2.5 } as const
        const run = simulate({ ...given, frames, timestep: { kind: 'tolerance', tolerance } })
        // Less than a second of it, at a condition of ten.
        expect(
          Math.abs(last(run.s) - exact(given, 0.8).s),
          `${integrator}, ${String(distance)}`,
        ).toBeLessThan(10 * tolerance)
      }
  })
})

describe('the policy', () => {
  const pipe: Experiment = { scene: 'half-pipe', integrator: 'rk8', duration: 1 }
  const timestep = { kind: 'tolerance', tolerance: 1e-9 } as const

  it('takes a second of half-pipe with rk8 at 60 fps in at most 2 500 evaluations', () => {
    expect(simulate({ ...pipe, timestep }).evaluations).toBeLessThanOrEqual(2500)
  })

  it('pays more for less: a tenth of the tolerance costs Verlet about √10 times the steps', () => {
    const steps = [1e-5, 1e-6, 1e-7].map(
      (tolerance) =>
        simulate({
          ...{ ...pipe, integrator: 'velocity-verlet', frames: { kind: 'steady', fps: 5 } },
          timestep: { kind: 'tolerance', tolerance },
        }).steps,
    ) as [number, number, number]
    // Whole steps in five frames, lengthened by 5 and shortened by what one estimate says: a fifth off at the most.
    for (const ratio of [steps[1] / steps[0], steps[2] / steps[1]])
      expect(Math.abs(ratio / Math.sqrt(10) - 1)).toBeLessThan(0.2)
  })

  it('keeps its step from frame to frame, and never takes one longer than the frame', () => {
    const run = simulate({ ...pipe, timestep, frames: { kind: 'steady', fps: 1000 } })
    // One pair of halves a frame from the first on.
    expect(run.steps).toBe(2 * run.frames)
  })
})
