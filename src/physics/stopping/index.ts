import { naive } from './naive.ts'
import { clamped } from './clamped.ts'
import { located } from './located.ts'

/** Every stopping rule, from the crudest to the exact one. */
export const stoppings = [naive, clamped, located] as const

export type StoppingId = (typeof stoppings)[number]['id']
