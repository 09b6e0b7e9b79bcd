import { describe, expect, it } from 'vitest'
import { readValues } from '../../src/figures/shared/control.ts'
import { figures } from '../../src/figures/index.ts'
import { mechanicalEnergy, spreadOf } from '../../src/measure/index.ts'
import { exact, forcesAt, length, simulate } from '../../src/physics/index.ts'
import type { Trajectory } from '../../src/physics/index.ts'
import { values } from '../../src/tutorial/facts/index.ts'

/** The runs of a figure after some of its controls were set. */
async function runsOf(id: string, given: Record<string, unknown> = {}) {
  const figure = await figures.find((each) => each.id === id)!.load()
  return figure.experiments(readValues(figure.controls, given)).map(simulate)
}

/** What a reader sees in a figure and what the prose beside it says are the same number. */
describe('the numbers of the prose are those of the figures', () => {
  const end = async (id: string, given: Record<string, unknown>, index = 0) =>
    (await runsOf(id, given))[index]!.drawnS.at(-1)!

  it('1: the falling ball', async () => {
    const fall = (fps: number, method: string) => end('falling-ball', { fps, method })
    expect(await fall(15, 'per-frame')).toBe(values.fallPerFrame15())
    expect(await fall(120, 'per-frame')).toBe(values.fallPerFrame120())
    expect((await fall(10, 'variable')) - values.fallTrue()).toBe(values.fallAhead10())
    expect((await fall(60, 'variable')) - values.fallTrue()).toBe(values.fallAhead60())
  })

  it('2: forces on a slope, and the two masses', async () => {
    const forces = async (angle: number) => {
      const { experiment } = (await runsOf('forces-on-slope', { angle }))[0]!
      return forcesAt(experiment, { s: 0, v: 1 })
    }
    expect(length((await forces(30)).gravity)).toBe(values.weight())
    expect(length((await forces(30)).normal)).toBe(values.normal30())
    expect(length((await forces(60)).normal)).toBe(values.normal60())
    const [light, heavy] = await runsOf('mass-cancels', { mass: 50 })
    expect(Math.abs(heavy!.s.at(-1)! - light!.s.at(-1)!)).toBe(values.massApart())
    expect(light!.experiment.duration).toBe(1.5)
  })

  it('3: the block sets off at the angle that the text says, and a slider’s notch below it stays', async () => {
    const outcome = async (angle: number) =>
      (await runsOf('critical-angle', { angle, mu: 0.45 }))[0]!.outcome.kind
    const critical = values.criticalFound()
    expect(await outcome(Math.floor(10 * critical) / 10)).toBe('at-rest')
    expect(await outcome(Math.ceil(10 * critical) / 10)).toBe('moving')
  })

  it('4: the area under v(t) is that of the ramp in the text', async () => {
    const [run] = await runsOf('area-under-v')
    expect(exact(run!.experiment, 2).s).toBe(values.rampTrue())
    expect(run!.experiment.duration).toBe(2)
  })

  it('5: the bet, the three stops, the trembling', async () => {
    const [truth] = await runsOf('where-does-it-stop')
    expect(truth!.experiment.parameters).toMatchObject({ angle: 10, muKinetic: 0.4, speed: -7 })
    expect(truth!.outcome.kind).toBe('at-rest')
    const stops = (await runsOf('three-stops', { mode: 'clamped' })).map(({ s }) => -s.at(-1)!)
    expect(stops).toEqual([values.clamped10(), values.clamped30(), values.clamped120()])
    const [chatter] = await runsOf('chatter', { fps: 60, stopping: 'naive' })
    expect(chatter!.experiment.parameters).toMatchObject({ angle: 15, muKinetic: 0.5, speed: -5 })
    expect(chatter!.outcome.kind).toBe('moving')
  })

  it('6: the hitch', async () => {
    const [variable, capped, substeps] = await runsOf('hitch')
    const off = ({ experiment, s }: Trajectory) => Math.abs(s.at(-1)! - exact(experiment, 1.4).s)
    expect(off(variable!)).toBe(values.hitchVariable())
    expect(off(substeps!)).toBe(values.hitchSubsteps())
    expect(capped!.lostTime).toBe(values.hitchLost())
    const players = await runsOf('your-engine')
    expect(spreadOf(players).distance).toBe(values.engineApart())
    const [ticks] = await runsOf('frames-and-ticks')
    expect(ticks!.experiment.timestep).toMatchObject({ kind: 'fixed', step: 1 / 20 })
  })

  it('7: energy in the pipe, and the block that is thrown out of it', async () => {
    const runs = await runsOf('half-pipe-energy', { fps: 60 })
    const semi = runs.find(({ experiment }) => experiment.integrator === 'semi-implicit-euler')!
    const energy = mechanicalEnergy(semi)
    const strays = Math.max(...energy.map((value) => Math.abs(value / energy[0]! - 1)))
    expect(semi.experiment.duration).toBe(10)
    expect(strays).toBe(values.pipeSemiSoon())
    const [flung] = await runsOf('flung-out', { fps: 60 })
    expect(flung!.outcome).toEqual({ kind: 'left-the-track', time: values.flungAfter() })
  })

  it('9: the slope on which the paper’s step runs', async () => {
    const [exactBlock] = await runsOf('paper-step')
    expect(exactBlock!.experiment).toMatchObject({
      parameters: { angle: 20, muKinetic: 0.5, speed: 3 },
      frames: { fps: 30 },
    })
  })
})
