import { execFileSync } from 'node:child_process'
import { join } from 'node:path'
import { build } from 'vite'
import { beforeAll, describe, expect, it } from 'vitest'
import type { Experiment, Outcome } from '../../src/physics/index.ts'

/**
 * The most evaluations that an accepted experiment may take: 5 000 000 steps, which is the most that are accepted, of eleven
 * each, and the events among them three times as much. At 10 to 20 ns each it is some seconds on an idle machine.
 */
const MOST_EVALUATIONS = 2e8

/** A run that hangs is stopped by force, so that a failure does not take an hour; no busy machine needs as long [ms]. */
const PATIENCE = 280_000

type Answer =
  { refused: string } | { evaluations: number; outcome: Outcome['kind'] } | { stoppedAfter: number }

let physics: string

beforeAll(async () => {
  const root = join(import.meta.dirname, '../..')
  const built = await build({
    root,
    configFile: false,
    logLevel: 'silent',
    build: {
      ...{ write: false, minify: false, target: 'es2022' },
      rolldownOptions: {
        input: join(root, 'src/physics/index.ts'),
        preserveEntrySignatures: 'strict',
        output: { format: 'iife', name: 'Physics' },
      },
    },
  })
  const { output } = (Array.isArray(built) ? built[0]! : built) as { output: { code: string }[] }
  physics = output[0]!.code
})

/** Simulates in a process of its own, since only that can be stopped from outside. */
function ask(experiment: Experiment): Answer {
  const script = `${physics}
    let answer
    try {
      const { evaluations, outcome } = Physics.simulate(${JSON.stringify(experiment)})
      answer = { evaluations, outcome: outcome.kind }
    } catch (error) {
      if (!(error instanceof Physics.ExperimentError)) throw error
      answer = { refused: error.message }
    }
    console.log(JSON.stringify(answer))`
  try {
    const options = { input: script, timeout: PATIENCE, encoding: 'utf8' } as const
    return JSON.parse(execFileSync(process.execPath, ['-'], options)) as Answer
  } catch (error) {
    if ((error as { code?: string }).code !== 'ETIMEDOUT') throw error
    return { stoppedAfter: PATIENCE }
  }
}

/** Refused with a figure, or ended within the bound. */
function expectBounded(answer: Answer): void {
  if ('refused' in answer) expect(answer.refused).toMatch(/\d.*(evaluation|step|frame)/)
  else {
    expect(answer).not.toHaveProperty('stoppedAfter')
    expect((answer as { evaluations: number }).evaluations).toBeLessThanOrEqual(MOST_EVALUATIONS)
  }
}

const spring = { scene: 'spring', stopping: 'located' } as const
const rubbed = { angle: 0, muStatic: 1e-6, muKinetic: 1e-6, position: 1 }

// ω is √stiffness here, as the mass is 1.
const hard: { name: string; experiment: Experiment }[] = [
  {
    name: 'sixty swings in each of a million Verlet steps',
    experiment: {
      ...{ ...spring, parameters: { ...rubbed, stiffness: 36100000038 } },
      ...{ frames: { kind: 'steady', fps: 1000 }, duration: 1000 },
    },
  },
  // Three methods that neither damp a swing nor blow it up below their limit, so that the turns do not end.
  ...(
    [
      ['velocity-verlet', 1990],
      ['yoshida4', 1500],
      ['implicit-midpoint', 2000],
    ] as const
  ).map(([integrator, omega]): { name: string; experiment: Experiment } => ({
    name: `a turn in most of five million steps of ${integrator}`,
    experiment: {
      ...{ ...spring, parameters: { ...rubbed, stiffness: omega ** 2 }, integrator },
      ...{ timestep: { kind: 'fixed', step: 1e-3 }, duration: 4900 },
    },
  })),
  {
    name: 'many swings in each of a million steps of implicit midpoint',
    experiment: {
      ...{ ...spring, parameters: { ...rubbed, stiffness: 1e12 } },
      ...{ integrator: 'implicit-midpoint', duration: 1000 },
      frames: { kind: 'steady', fps: 1000 },
    },
  },
  {
    name: 'a turn in most of five million steps in a tiny pipe in heavy gravity',
    experiment: {
      scene: 'half-pipe',
      parameters: {
        radius: 0.001,
        gravity: 3600,
        muStatic: 1e-9,
        muKinetic: 1e-9,
        position: 0.001,
      },
      ...{ timestep: { kind: 'fixed', step: 1e-3 }, duration: 4900 },
    },
  },
  {
    name: 'a million frames, each of many times a bend’s own time',
    experiment: {
      scene: 'run-out',
      parameters: { angle: 90, length: 0, bendRadius: 0.001, gravity: 1e6, muKinetic: 1e-6 },
      ...{ integrator: 'rk8', frames: { kind: 'steady', fps: 100 }, duration: 1e4 },
    },
  },
  {
    name: 'five million steps with stiff drag',
    experiment: {
      scene: 'fall',
      parameters: { drag: 1e6, mass: 1e-3, speed: 100 },
      ...{ integrator: 'implicit-midpoint', duration: 4900 },
      timestep: { kind: 'fixed', step: 1e-3 },
    },
  },
]

describe('with stops located no run takes more work than is stated, or it is refused', () => {
  it.each(hard)('$name', ({ experiment }) => {
    expectBounded(ask(experiment))
  })
})

it('the bound refuses no run that a game or the page makes', () => {
  const answer = ask({
    scene: 'half-pipe',
    ...{ integrator: 'rk8', frames: { kind: 'steady', fps: 240 }, duration: 600 },
  })
  expect(answer).toHaveProperty('outcome', 'moving')
  const stiff = ask({
    ...{ ...spring, parameters: { ...rubbed, stiffness: 4000 } },
    ...{ integrator: 'rk4', frames: { kind: 'steady', fps: 144 }, duration: 60 },
  })
  expect(stiff).toHaveProperty('outcome', 'moving')
})
