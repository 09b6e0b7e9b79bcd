import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { join, relative } from 'node:path'
import ts from 'typescript'
import { build } from 'vite'
import { describe, expect, test } from 'vitest'
import { followed, root } from './extending.ts'

/* docs/extending.md, followed to the letter: what it tells to write compiles, and runs. */

const files = followed(readFileSync(join(root, 'docs/extending.md'), 'utf8'))
const pathIn = (file: string) => relative(root, file).replaceAll('\\', '/')

test('its code and its diffs fit the sources, and the result compiles', () => {
  const { config } = ts.readConfigFile(join(root, 'tsconfig.json'), ts.sys.readFile) as {
    config: unknown
  }
  const { options } = ts.parseJsonConfigFileContent(config, ts.sys, root)
  const host = ts.createCompilerHost({ ...options, noEmit: true })
  const { fileExists, readFile, getSourceFile } = host
  host.fileExists = (file) => files.has(pathIn(file)) || fileExists(file)
  host.readFile = (file) => files.get(pathIn(file)) ?? readFile(file)
  host.getSourceFile = (file, languageVersion, ...others) => {
    const text = files.get(pathIn(file))
    return text === undefined
      ? getSourceFile(file, languageVersion, ...others)
      : ts.createSourceFile(file, text, languageVersion, true)
  }
  const entries = ['src/main.ts', 'src/elements.ts', ...files.keys()].map((each) =>
    join(root, each),
  )
  const program = ts.createProgram(entries, { ...options, noEmit: true }, host)
  const wrong = program
    .getSourceFiles()
    .flatMap((file) =>
      /node_modules/.test(file.fileName)
        ? []
        : program
            .getSemanticDiagnostics(file)
            .map(
              ({ messageText }) =>
                `${file.fileName}: ${ts.flattenDiagnosticMessageText(messageText, ' ')}`,
            ),
    )
  expect(wrong).toEqual([])
})

/** What a program prints that imports the physics with everything of the text in it. */
async function printed(program: string): Promise<string> {
  const entry = 'virtual:followed'
  const built = await build({
    root,
    configFile: false,
    logLevel: 'silent',
    build: {
      write: false,
      minify: false,
      rolldownOptions: { input: entry, output: { format: 'es' } },
    },
    plugins: [
      {
        name: 'followed',
        enforce: 'pre',
        resolveId: (id, importer) => {
          if (id === entry) return join(root, 'followed.ts')
          const file = importer && id.startsWith('.') ? join(importer, '..', id) : ''
          return files.has(pathIn(file)) ? file : null
        },
        load: (id) => (pathIn(id) === 'followed.ts' ? program : (files.get(pathIn(id)) ?? null)),
      },
    ],
  })
  const { output } = (Array.isArray(built) ? built[0]! : built) as { output: { code: string }[] }
  return execFileSync('node', ['--input-type=module', '--eval', output[0]!.code], {
    encoding: 'utf8',
  })
}

describe('what it adds runs', () => {
  const results = printed(`
    import { exact, simulate } from './src/physics/index.ts'
    const end = (experiment) => {
      const { s, stateTime, time, outcome, steps, frames, lostTime } = simulate(experiment)
      const truth = exact(experiment, stateTime.at(-1)).s
      return { error: s.at(-1) - truth, outcome, steps, frames, lostTime, time: [...time.slice(0, 4)] }
    }
    const kick = { scene: 'ramp', parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 }, duration: 1 }
    const halfPipe = { scene: 'half-pipe', integrator: 'heun', duration: 1 }
    const steady = (fps) => ({ frames: { kind: 'steady', fps } })
    console.log(JSON.stringify({
      exactStop: end({ ...kick, integrator: 'heun' }),
      coarse: end({ ...halfPipe, ...steady(200) }),
      fine: end({ ...halfPipe, ...steady(400) }),
      valley: end({ scene: 'valley', integrator: 'rk8', ...steady(240) }),
      pulldown: end({ ...kick, frames: { kind: 'pulldown', fps: 60 } }),
      sleeping: end({ ...kick, stopping: 'sleeping', integrator: 'semi-implicit-euler', ...steady(960) }),
      halves: end({ ...kick, timestep: { kind: 'halves' }, ...steady(10) }),
    }))`).then((text) => JSON.parse(text) as Record<string, Ended>)

  type Ended = {
    error: number
    outcome: { kind: string; time: number }
    steps: number
    frames: number
    lostTime: number
    time: number[]
  }

  test('the integrator: exact on the ramp, and of the second order in the half-pipe', async () => {
    const { exactStop, coarse, fine } = await results
    expect(exactStop!.outcome.kind).toBe('at-rest')
    expect(Math.abs(exactStop!.error)).toBeLessThan(1e-12)
    // The error falls with the square of the step, and with its cube by a small share more.
    expect(Math.log2(coarse!.error / fine!.error)).toBeCloseTo(2, 1)
  })

  test('the scene: its motion follows from the track, through both joints', async () => {
    const { valley } = await results
    expect(valley!.outcome.kind).not.toBe('diverged')
    expect(Math.abs(valley!.error)).toBeLessThan(1e-9)
  })

  test('the clock: frames of three refreshes and of two', async () => {
    const { pulldown } = await results
    expect(pulldown!.time).toEqual([0, 3 / 60, 5 / 60, 8 / 60])
    expect(Math.abs(pulldown!.error)).toBeLessThan(1e-12)
  })

  test('the stopping rule: the block rests, not quite where it should', async () => {
    const { sleeping } = await results
    expect(sleeping!.outcome.kind).toBe('at-rest')
    // The method's own error is of the size v Δt; the last centimetre a second is v²/2a.
    expect(Math.abs(sleeping!.error)).toBeLessThan(5 / 960)
  })

  test('the policy: two steps a frame, and no time lost', async () => {
    const { halves } = await results
    expect(halves!.frames).toBe(10)
    expect(halves!.steps).toBe(20)
    expect(halves!.lostTime).toBe(0)
    expect(Math.abs(halves!.error)).toBeLessThan(1e-12)
  })
})
