import { execFileSync } from 'node:child_process'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { build } from 'vite'
import { afterAll, describe, expect, it } from 'vitest'
import type * as physicsModule from '../../src/physics/index.ts'
import type { Experiment, Run } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'

/*
 * What is measured is the module as it is built, since that is what runs in a page and in a game: Vitest puts a getter
 * in front of every import, and V8 inlines less across those.
 */
const folder = mkdtempSync(join(tmpdir(), 'any-frame-rate-'))
afterAll(() => {
  rmSync(folder, { recursive: true })
})
await build({
  configFile: false,
  logLevel: 'silent',
  build: {
    outDir: folder,
    minify: false,
    target: 'es2022',
    lib: {
      entry: join(import.meta.dirname, '../../src/physics/index.ts'),
      formats: ['es'],
      fileName: () => 'physics.mjs',
    },
  },
})
const { createRun, integrators, scenes, stoppings, traceFrame } = (await import(
  /* @vite-ignore */ pathToFileURL(join(folder, 'physics.mjs')).href
)) as typeof physicsModule

const STEPS = samples(300_000, 1_000_000)

/** [s] So short that a block moves on through all of a test's frames, some 24 million at the most. */
const FRAME = 1 / 1024

/** As a game loop does. */
function step(run: Run, count: number): void {
  for (let i = 0; i < count; i++) run.frame(FRAME)
}

/** As `simulate` does, whose clock counts for itself. */
function advance(run: Run, count: number): void {
  run.frameDuration = FRAME
  for (let i = 0; i < count; i++) {
    run.gameTime = run.time += FRAME
    run.advanceFrame()
  }
}

/** One boxed number a step, of 12 to 16 bytes, takes a hundred times what is allowed for what the engine does on the side. */
const NOTHING = STEPS / 8

/**
 * Bytes that STEPS steps of a run take from the heap once the engine has compiled what they call. The young generation
 * of the test process holds 64 MB, so that nothing is collected in between. A quiet round counts: the engine itself may use
 * memory at any time, and on a busy machine it takes a while to compile.
 */
function bytes(experiment: Experiment, take = step): number {
  const run = createRun(experiment)
  let least = Infinity
  for (let round = 0; round < 12 && least > NOTHING; round++) {
    globalThis.gc!()
    take(run, STEPS)
    const before = process.memoryUsage().heapUsed
    take(run, STEPS)
    least = Math.min(least, Math.abs(process.memoryUsage().heapUsed - before))
  }
  // Of a block at rest or off the track no step would have been measured.
  expect(run.outcome.kind).toBe('moving')
  return least
}

/** Prints the bytes of a step of each method, compiled after the law of motion was compiled by itself. */
const forced = `
  import { createRun, integrators } from ${JSON.stringify(pathToFileURL(join(folder, 'physics.mjs')).href)}
  const parameters = { muStatic: 0, muKinetic: 0 }
  const start = (integrator) => {
    const { motion } = createRun({ scene: 'half-pipe', parameters, integrator })
    motion.dt = ${FRAME}
    return motion
  }
  const { acceleration } = Object.getPrototypeOf(start('rk4'))
  const compiled = (f, use) => {
    %PrepareFunctionForOptimization(f);
    use(1000);
    %OptimizeFunctionOnNextCall(f);
    use(1)
  }
  const bytes = {}
  for (const { id, step } of integrators) {
    const motion = start(id)
    compiled(acceleration, (count) => {
      for (let i = 0; i < count; i++) acceleration.call(motion, 0.5, 0.5)
    })
    const use = (count) => {
      for (let i = 0; i < count; i++) step(motion)
    }
    compiled(step, use)
    bytes[id] = Infinity
    for (let round = 0; round < 5; round++) {
      use(100_000)
      gc()
      const before = process.memoryUsage().heapUsed
      use(100_000)
      bytes[id] = Math.min(bytes[id], (process.memoryUsage().heapUsed - before) / 100_000)
    }
  }
  console.log(JSON.stringify(bytes))
`

// Code whose coverage is counted is compiled otherwise, and allocates.
const counted = process.env.npm_lifecycle_event === 'coverage'

describe.skipIf(counted)('a step allocates nothing', () => {
  const experiments: Experiment[] = [
    { scene: 'ramp' },
    { scene: 'ramp', parameters: { speed: 3 }, timestep: { kind: 'fixed', step: 1 / 500 } },
    { scene: 'half-pipe', integrator: 'rk4' },
    { scene: 'ramp', timestep: { kind: 'substeps', step: 1 / 2000 } },
    { scene: 'ramp', timestep: { kind: 'capped', cap: 1 / 2000 } },
    { scene: 'ramp', timestep: { kind: 'per-frame', step: 1 / 1000 } },
    // With so little friction a swing lasts for hours.
    { scene: 'half-pipe', integrator: 'yoshida4', parameters: { muKinetic: 1e-6, muStatic: 1e-6 } },
    { scene: 'spring', integrator: 'implicit-midpoint', parameters: { muKinetic: 0, muStatic: 0 } },
    { scene: 'fall', integrator: 'midpoint', parameters: { drag: 0.1 } },
    {
      ...{ scene: 'half-pipe', integrator: 'semi-implicit-euler', stopping: 'clamped' },
      parameters: { muKinetic: 1e-6, muStatic: 1e-6 },
    },
    {
      ...{ scene: 'run-out', integrator: 'semi-implicit-euler', stopping: 'clamped' },
      parameters: { muKinetic: 0, muStatic: 0 },
    },
    { scene: 'ramp', integrator: 'explicit-euler', stopping: 'naive' },
    { scene: 'belt', integrator: 'rk4' },
    { scene: 'half-pipe', timestep: { kind: 'tolerance', tolerance: 1e-6 } },
    ...integrators.map(({ id }) => ({ scene: 'ramp', integrator: id }) as const),
  ]

  it.each(experiments)('$scene $integrator $stopping $timestep', (experiment) => {
    expect(bytes(experiment)).toBeLessThan(NOTHING)
    expect(bytes(experiment, advance)).toBeLessThan(NOTHING)
  })

  it('also after the same code has run every scene, method and rule, and been traced', () => {
    for (let round = 0; round < 3; round++)
      for (const { id: scene } of scenes)
        for (const { id: integrator } of integrators)
          for (const { id: stopping } of stoppings)
            step(createRun({ scene, integrator, stopping }), 5000)
    traceFrame({ scene: 'half-pipe', integrator: 'rk4' }, 3)
    for (const experiment of experiments)
      for (const take of [step, advance])
        expect(bytes(experiment, take), JSON.stringify(experiment)).toBeLessThan(NOTHING)
  })

  it('whichever function the engine compiles first', () => {
    // V8 compiles what is hot, in an order that no two processes share. Here it is told: the law alone, then the methods.
    const found = execFileSync(
      process.execPath,
      ['--allow-natives-syntax', '--expose-gc', '--min-semi-space-size=64', '--input-type=module'],
      { input: forced, encoding: 'utf8' },
    )
    const bytes = JSON.parse(found) as Record<string, number>
    expect(Object.keys(bytes)).toHaveLength(integrators.length)
    // Half of a boxed number: the engine compiles the loop around the steps meanwhile.
    for (const [id, each] of Object.entries(bytes)) expect(each, id).toBeLessThan(6)
  })

  it('and the measure would notice: one number boxed a step is seen', () => {
    const kept: { boxed: number }[] = []
    globalThis.gc!()
    const before = process.memoryUsage().heapUsed
    for (let i = 0; i < STEPS; i++) kept[i & 1023] = { boxed: i + 0.5 }
    expect(process.memoryUsage().heapUsed - before).toBeGreaterThan(NOTHING)
    expect(kept).toHaveLength(1024)
  })
})
