import { format, resolveConfig } from 'prettier'

/** A text as the project's formatter would leave it. `file`, from the project's root, says what kind of text it is. */
export async function formatted(text: string, file: string): Promise<string> {
  return format(text, { ...(await resolveConfig(file)), filepath: file })
}
