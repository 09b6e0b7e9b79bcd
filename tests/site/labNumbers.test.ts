import { expect, test } from 'vitest'
import { exactMotion, simulate } from '../../src/physics/index.ts'
import type { Trajectory } from '../../src/physics/index.ts'
import { readAddress } from '../../src/lab/state/address.ts'
import { experimentOf } from '../../src/lab/state/check.ts'
import { lengthText } from '../../src/chart/numbers.ts'
import { errorText } from '../../src/panels/runners/results.ts'
import { Simulation } from '../../src/lab/state/simulation.ts'
import { openLab, openLabOverText } from './labPage.ts'

const columns = ['time', 'stateTime', 's', 'v', 'drawnS', 'heat'] as const

const addresses = [
  '',
  'scene=fall&drag=0.7',
  'scene=run-out&runners=10/semi-implicit-euler/naive;jitter(fps:30,amount:0.9,seed:3);hitch(fps:60,every:0.7,length:0.5)/rk4',
  'scene=half-pipe&duration=10&muKinetic=0.1&runners=24/midpoint/clamped;missed-vsync(fps:60,seed:5)/yoshida4;30/explicit-euler',
  'scene=spring&runners=30/fixed(step:1/60);25/capped(cap:0.03)/implicit-midpoint;recorded(durations:0.016+0.05)/substeps(step:0.01)',
  `scene=half-pipe&duration=10&runners=${Array.from({ length: 8 }, (_, i) => `240/look(${i})/rk4`).join(';')}`,
]

test.each(addresses)(
  'what the page shows for “%s” is what simulate returns in Node',
  async (address) => {
    const state = readAddress(address)
    const expected = state.runners.map((runner) => simulate(experimentOf(state, runner)))
    const lab = await openLab(address)
    const shown = await lab.page.evaluate((columns) => {
      const { trajectories } = document.querySelector('slide-lab') as unknown as {
        trajectories: Trajectory[]
      }
      return trajectories.map((trajectory) => ({
        // Bits, not numbers: −0 is not 0, and nothing is rounded on the way.
        columns: columns.map((name) => {
          const bytes = new Uint8Array(trajectory[name].slice().buffer)
          return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('')
        }),
        outcome: trajectory.outcome,
        experiment: trajectory.experiment,
      }))
    }, columns)
    expected.forEach((trajectory, i) => {
      expect(shown[i]!.outcome).toEqual(trajectory.outcome)
      expect(shown[i]!.experiment).toEqual(trajectory.experiment)
      columns.forEach((name, column) => {
        const bits = Buffer.from(trajectory[name].slice().buffer).toString('hex')
        expect(shown[i]!.columns[column] === bits, `${name} of runner ${i}`).toBe(true)
      })
    })

    const simulated = new Simulation().run(state)
    expect(await lab.page.locator('slide-runner-row .end output').allInnerTexts()).toEqual(
      expected.map((trajectory) => errorText(simulated, trajectory, trajectory.frames).text),
    )
    const ends = expected.map(({ drawnS }) => drawnS.at(-1)!)
    expect(await lab.spread()).toBe(lengthText(Math.max(...ends) - Math.min(...ends)))
    expect(lab.problems).toEqual([])
  },
)

test('after a change too, and at every instant', async () => {
  const lab = await openLab()
  await lab.slider('Angle').fill('22')
  await lab.page.getByRole('button', { name: 'The paper' }).click()
  await lab.time().fill('0.5')
  const state = await lab.state()
  const [ten] = state.runners.map((runner) => simulate(experimentOf(state, runner)))
  const exact = exactMotion(experimentOf(state, state.runners[0]!))
  const error = ten!.drawnS[5]! - exact(ten!.time[5]!, { s: 0, v: 0 }).s
  expect(ten!.time[5]).toBe(0.5)
  expect(await lab.runner(0).locator('.now output').innerText()).toBe(
    errorText(new Simulation().run(state), ten!, 5).text,
  )
  expect(await lab.runner(0).locator('.now output').getAttribute('title')).toContain(String(error))
})

test('where the browser’s language has a decimal comma, fields show and take it', async () => {
  const lab = await openLabOverText('mass=1.5', { locale: 'de-DE' })
  const mass = lab.field('Mass')
  expect(await lab.field('Gravity').inputValue()).toBe('9,81')
  expect(await mass.inputValue()).toBe('1,5')
  await mass.fill('1,234')
  await mass.press('Enter')
  expect((await lab.state()).parameters.mass).toBe(1.234)
  await lab.address(/^#mass=1\.234$/)
  expect(await lab.page.locator('.dial input').nth(7).inputValue()).toMatch(/^\d+,\d+$/)
})
