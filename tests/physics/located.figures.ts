// How far located runs end from the truth on short bends under hitches, by method. From the root:
// npx rolldown tests/physics/located.figures.ts -p node -o /tmp/located.mjs && node /tmp/located.mjs [count] [seed]
import { secondOrder, shortBends } from './generated.ts'
import { endsOf, located, summary } from './located.ts'

const [count = 5000, seed = 1] = process.argv.slice(2).map(Number)
const cases = shortBends(count, seed)
const ends = endsOf(cases)
for (const integrator of secondOrder) {
  const start = process.cpuUsage().user
  const found = located(cases, ends, integrator)
  const seconds = (process.cpuUsage().user - start) / 1e6
  console.log(`${summary(integrator, count, found)}, ${seconds.toFixed(1)} s`)
  console.log(`  first cases over 0.5 m: ${found.overHalf.slice(0, 8).join(' ')}`)
  console.log(`  first cases at rest that are not: ${found.falseRests.slice(0, 8).join(' ')}`)
}
