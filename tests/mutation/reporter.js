/* Says at once which mutants no test has found, and how many have been tried: a run takes a while. */
class AsTheyCome {
  tried = 0

  onMutantTested({ status, fileName, location, mutatorName, replacement }) {
    this.tried++
    if (status === 'Killed') return
    const { line, column } = location.start
    const file = fileName.replace(/.*src\/physics\//, '')
    console.log(
      `${this.tried}: ${status} ${file}:${line}:${column} ${mutatorName} → ${replacement.replaceAll(/\s+/g, ' ')}`,
    )
  }
}

export const strykerPlugins = [
  { kind: 'Reporter', name: 'as-they-come', injectableClass: AsTheyCome },
]
