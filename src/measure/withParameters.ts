type Values = Readonly<Record<string, unknown>>

/**
 * Replaces some parameters. Static friction is never below kinetic: if one of the two is set, the other
 * follows it. If both are set, or one is not a number, `parseExperiment` checks them.
 */
export function withParameters<P extends Values, V extends Values>(parameters: P, set: V): P & V {
  const all: P & V = { ...parameters, ...set }
  const { muStatic, muKinetic } = all
  if (typeof muStatic !== 'number' || typeof muKinetic !== 'number' || muStatic >= muKinetic)
    return all
  const [setsStatic, setsKinetic] = ['muStatic' in set, 'muKinetic' in set]
  if (setsStatic === setsKinetic) return all
  return setsStatic ? { ...all, muKinetic: muStatic } : { ...all, muStatic: muKinetic }
}
