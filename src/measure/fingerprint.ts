import {
  defaults,
  frameClocks,
  integrators,
  measuring,
  scenes,
  simulate,
  stoppings,
  timesteps,
} from '../physics/index.ts'
import type { Experiment, NumberOption, Option, Options, Scene } from '../physics/index.ts'

/** Twice every scene with every method and rule, so that each meets the policies and the clocks in rotation. */
const ROUNDS = 2

/**
 * A hash of what the physics computes: every row of 210 runs and more, all scenes × methods × rules with the policies, the
 * clocks and the parameters in rotation, and every wrong delta with every policy. Engines that agree on it agree on every
 * bit of the runs.
 *
 * @param experiments of which it is; by default all of `fingerprintExperiments`
 * @returns how many runs there were, and FNV-1a (Fowler, Noll & Vo, 64 bits) of their bytes in hexadecimal digits
 */
export function fingerprint(experiments = fingerprintExperiments()): {
  experiments: number
  hash: string
} {
  const hash = new Hash()
  for (const experiment of experiments) {
    const run = simulate(experiment)
    const { time, stateTime, s, v, drawnS, heat } = run
    for (const column of [time, stateTime, s, v, drawnS, heat])
      for (const value of column) hash.add(value)
    for (const total of [run.frames, run.steps, run.evaluations, run.unsolved, run.lostTime])
      hash.add(total)
    hash.add(run.outcome.time)
  }
  return { experiments: experiments.length, hash: hash.digits }
}

/** The experiments behind it, made from the lists: a new entry changes the fingerprint. */
export function fingerprintExperiments(): Experiment[] {
  let turn = 0
  const experiments: Experiment[] = []
  for (let round = 0; round < ROUNDS; round++)
    for (const scene of scenes)
      for (const { id: integrator } of integrators)
        for (const { id: stopping } of stoppings) {
          // With each round of the policies they go on by one, so that each meets every rule, and the clocks by two, so that
          // each policy meets every clock.
          const rounds = Math.floor(turn / timesteps.length)
          const timestep = timesteps[(turn + rounds) % timesteps.length]!
          const clock = frameClocks[(turn + 2 * rounds) % frameClocks.length]!
          experiments.push({
            scene: scene.id,
            parameters: parametersOf(scene, turn),
            integrator,
            stopping,
            timestep: { kind: timestep.id, ...settings(timestep.options, turn) },
            frames: { kind: clock.id, ...settings(clock.options, turn) },
            // A method of first order would take hundreds of thousands of steps a second to a tolerance.
            duration: timestep.id === 'tolerance' ? 0.05 : 1.5,
          } as Experiment)
          turn++
        }
  return [...experiments, ...measuredExperiments()]
}

/** Every wrong delta with every policy, on the clocks in rotation, in slow motion and in fast. */
function measuredExperiments(): Experiment[] {
  const wrong = measuring.delta.choices.filter((delta) => delta !== measuring.delta.initial)
  return wrong.flatMap((delta, i) =>
    timesteps.map((timestep, j) => {
      const turn = i * timesteps.length + j
      const clock = frameClocks[(i + j) % frameClocks.length]!
      return {
        scene: scenes[turn % scenes.length]!.id,
        parameters: parametersOf(scenes[turn % scenes.length]!, turn),
        ...defaults,
        timestep: { kind: timestep.id, ...settings(timestep.options, turn) },
        frames: {
          kind: clock.id,
          ...settings(clock.options, turn),
          ...settings(measuring, turn),
          delta,
        },
        duration: timestep.id === 'tolerance' ? 0.05 : 1.5,
        timeScale: turn % 2 === 0 ? 0.25 : 1.5,
      } as Experiment
    }),
  )
}

/** Values within the sliders' ranges, different at every turn. */
function settings(options: Options, turn: number): Record<string, unknown> {
  return Object.fromEntries(
    Object.entries(options).map(([name, option], i) => [name, setting(option, turn + 7 * i)]),
  )
}

function setting(option: Option, turn: number): unknown {
  if (option.type === 'choice') return option.choices[turn % option.choices.length]
  if (option.type === 'list') return [1, 3, 2].map((part) => part * option.initial[0]!)
  return within(option, turn)
}

/** The multiples of the golden section, less their whole parts, spread evenly (Weyl). */
function within({ integer, slider: { from, to } }: NumberOption, turn: number): number {
  const part = ((turn + 1) * 0.6180339887498949) % 1
  const value = from + (to - from) * part
  return integer ? Math.floor(value) : value
}

function parametersOf(scene: Scene, turn: number): Record<string, number> {
  const parameters = settings(scene.parameters, turn) as Record<string, number>
  const { muStatic, muKinetic } = parameters
  // Static friction below kinetic is refused.
  if (muStatic! < muKinetic!) parameters.muStatic = muKinetic!
  for (;;) {
    const conflict = scene.conflict?.(parameters)
    if (!conflict) return parameters
    parameters[conflict.parameter]! /= 2
  }
}

/** FNV-1a in four parts of 16 bits, so that no product is too large for a floating-point number. */
class Hash {
  // The offset basis, 0xcbf29ce484222325, the lowest part first.
  private a = 0x2325
  private b = 0x8422
  private c = 0x9ce4
  private d = 0xcbf2
  private readonly view = new DataView(new ArrayBuffer(8))

  add(value: number): void {
    this.view.setFloat64(0, value, true)
    for (let i = 0; i < 8; i++) this.addByte(this.view.getUint8(i))
  }

  private addByte(byte: number): void {
    // Times the prime 2⁴⁰ + 0x1b3.
    const a = (this.a ^ byte) * 0x1b3
    const b = this.b * 0x1b3 + (a >>> 16)
    const c = this.c * 0x1b3 + ((this.a ^ byte) << 8) + (b >>> 16)
    const d = this.d * 0x1b3 + (this.b << 8) + (c >>> 16)
    this.a = a & 0xffff
    this.b = b & 0xffff
    this.c = c & 0xffff
    this.d = d & 0xffff
  }

  get digits(): string {
    return [this.d, this.c, this.b, this.a]
      .map((part) => part.toString(16).padStart(4, '0'))
      .join('')
  }
}
