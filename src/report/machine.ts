import { cpus, release, type } from 'node:os'
import type { Machine } from './schema.ts'

/** What the figures were measured on. */
export function machine(rounds: number, quick: boolean): Machine {
  const processors = cpus()
  return {
    date: new Date().toISOString(),
    processor: processors[0]?.model.trim() || 'unknown',
    cores: processors.length,
    system: `${type()} ${release()}`,
    node: process.versions.node,
    v8: process.versions.v8,
    rounds,
    quick,
  }
}
