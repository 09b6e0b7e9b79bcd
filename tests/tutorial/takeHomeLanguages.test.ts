import { execFileSync, spawnSync } from 'node:child_process'
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join, resolve } from 'node:path'
import { afterAll, describe, expect, it } from 'vitest'
import { cases3d, furthestOff3d } from './take-home/cases3d.ts'
import { slid } from './take-home/slid.ts'
import { cases, casesText, furthestOff, rowsOf } from './take-home/cases.ts'

const step = resolve(import.meta.dirname, '../../src/tutorial/take-home')
const here = resolve(import.meta.dirname, 'take-home')
const folder = mkdtempSync(join(tmpdir(), 'take-home-'))
afterAll(() => rmSync(folder, { recursive: true }))

/** The first of some programs that starts here. */
function found(names: readonly string[], flag = '--version'): string | undefined {
  return names.find((name) => spawnSync(name, [flag], { stdio: 'ignore' }).status === 0)
}

/** The test's title, which says why it is skipped where it is. A reporter may be silent about that: so it is printed too. */
function title(language: string, tool: string | undefined, wanted: string): string {
  if (tool) return `${language}, with ${tool}, gives the numbers of simulate`
  const missing = `${language} is NOT TESTED here: ${wanted} not found`
  console.warn(`The step to take home: ${missing}. CONTRIBUTING says how to get it.`)
  return missing
}

/** What a program writes. One that does not read what it is given fails on that: compilers are given nothing. */
function run(command: string, args: readonly string[], input = ''): string {
  return execFileSync(command, args, {
    input,
    cwd: folder,
    encoding: 'utf8',
    maxBuffer: 2 ** 26,
  })
}

function expectSame(output: string, tolerance: (frames: number) => number): void {
  const { flat, inSpace } = rowsOf(output)
  flat.forEach((rows, i) => {
    const one = cases[i]!
    expect(rows.length, one.name).toBe(one.frames.length)
    expect(furthestOff(one, rows), one.name).toBeLessThan(tolerance(rows.length))
  })
  inSpace.forEach((rows, i) => {
    const one = cases3d[i]!
    expect(rows.length, one.name).toBe(one.frames.length)
    // A step has some hundred parts at most in the frame in which it stops, and a few in any other.
    const bound = 10 * tolerance(rows.length + 300)
    expect(furthestOff3d(rows, slid(one)), one.name).toBeLessThan(bound)
  })
}

// As for step.ts: some ten roundings a frame.
const double = () => 1e-12
// Unity's and Godot's vectors hold numbers of 24 bits; ten roundings a frame, of the position and of the velocity that
// it follows from.
const single = (frames: number) => 20 * (frames + 1) * 2 ** -24

describe('the step to take home in other languages', () => {
  const compiler = found(['g++', 'clang++'])
  it.skipIf(!compiler)(title('C++', compiler, 'g++ or clang++'), { timeout: 60000 }, () => {
    const program = join(folder, 'step')
    const strict = ['-std=c++17', '-Wall', '-Wextra', '-Werror', '-ffp-contract=off']
    run(compiler!, [...strict, '-I', here, '-I', step, join(here, 'main.cpp'), '-o', program])
    expectSame(run(program, [], casesText()), double)
  })

  const dotnet = found(['dotnet']) ?? (found(['mono']) && found(['mcs']))
  it.skipIf(!dotnet)(title('C#', dotnet, 'dotnet or mcs'), { timeout: 120000 }, () => {
    const files = [join(step, 'Step.cs'), join(step, 'Step3D.cs'), join(here, 'Main.cs')]
    if (dotnet === 'mcs') {
      run('mcs', ['-out:step.exe', ...files])
      return expectSame(run('mono', ['step.exe'], casesText()), single)
    }
    const version = /^\d+/.exec(execFileSync('dotnet', ['--version'], { encoding: 'utf8' }))![0]
    writeFileSync(
      join(folder, 'step.csproj'),
      `<Project Sdk="Microsoft.NET.Sdk"><PropertyGroup><OutputType>Exe</OutputType>
<TargetFramework>net${version}.0</TargetFramework><EnableDefaultCompileItems>false</EnableDefaultCompileItems>
</PropertyGroup><ItemGroup>${files.map((file) => `<Compile Include="${file}" />`).join('')}</ItemGroup></Project>`,
    )
    run('dotnet', ['build', '--output', 'built'])
    expectSame(run('dotnet', [join('built', 'step.dll')], casesText()), single)
  })

  const godot = found(['godot', 'godot4'])
  it.skipIf(!godot)(title('GDScript', godot, 'godot'), { timeout: 120000 }, () => {
    writeFileSync(join(folder, 'project.godot'), 'config_version=5\n')
    for (const file of ['step.gd', 'step3d.gd']) copyFileSync(join(step, file), join(folder, file))
    const numbers = casesText()
      .split('\n')
      .map((line) => `\t[${line.split(' ').map(decimal).join(', ')}],`)
    const main = readFileSync(join(here, 'main.gd'), 'utf8')
    writeFileSync(join(folder, 'main.gd'), `${main}\n\nconst CASES = [\n${numbers.join('\n')}\n]\n`)
    expectSame(run(godot!, ['--headless', '--path', folder, '--script', 'res://main.gd']), single)
  })
})

/** A number that GDScript reads as one with decimals. */
function decimal(number: string): string {
  return /^-?\d+$/.test(number) ? `${number}.0` : number
}
