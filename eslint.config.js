import { defineConfig, globalIgnores } from 'eslint/config'
import tseslint from 'typescript-eslint'

// Engines disagree about the last bits of these. The step path uses + - * / and Math.sqrt, which all
// engines round alike, and its own sine and cosine.
const engineDependent = [
  ...['sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'atan2'],
  ...['sinh', 'cosh', 'tanh', 'asinh', 'acosh', 'atanh'],
  ...['exp', 'expm1', 'log', 'log1p', 'log2', 'log10', 'pow', 'hypot', 'cbrt'],
]

const property = (object, name, message) => ({ object, property: name, message })

const noRandom = property('Math', 'random', 'Physics is deterministic: use a seeded generator.')
const noEngineMaths = engineDependent.map((name) =>
  property('Math', name, `Math.${name} differs between engines in its last bits.`),
)

const noClock = ['Date', 'performance'].map((name) => ({
  name,
  message: 'Physics has no clock: time is counted in frames and steps.',
}))

const noMathsByOtherNames = [
  {
    selector: "VariableDeclarator[init.name='Math']",
    message: 'Write Math.name in full, so that the ban on engine-dependent functions can see it.',
  },
  {
    selector: "MemberExpression[object.name='Math'][computed=true]",
    message: 'Write Math.name in full, so that the ban on engine-dependent functions can see it.',
  },
]

const noPower = {
  selector: ":matches(BinaryExpression[operator='**'], AssignmentExpression[operator='**='])",
  message: 'x ** y differs between engines in its last bits: multiply.',
}

export default defineConfig(
  globalIgnores(['dist/', 'package/', 'test-results/']),
  tseslint.configs.strict,
  {
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    rules: {
      eqeqeq: 'error',
      'no-console': 'error',
      'no-var': 'error',
      'object-shorthand': 'error',
      'prefer-const': 'error',
      '@typescript-eslint/consistent-type-imports': [
        'error',
        { fixStyle: 'separate-type-imports' },
      ],
      // An index that the loop keeps in range is clearer with `!` than with a branch no test can reach.
      '@typescript-eslint/no-non-null-assertion': 'off',
      '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_' }],
    },
  },
  {
    files: ['src/physics/**'],
    rules: {
      'no-restricted-globals': ['error', ...noClock],
      'no-restricted-properties': ['error', noRandom, ...noEngineMaths],
      'no-restricted-syntax': ['error', noPower, ...noMathsByOtherNames],
    },
  },
  {
    // The exact solutions are what steps are judged by, never part of a step.
    files: ['src/physics/exact/**'],
    rules: {
      'no-restricted-properties': ['error', noRandom],
      'no-restricted-syntax': ['error', ...noMathsByOtherNames],
    },
  },
  {
    // They speak to a terminal.
    files: ['src/report/**', 'tests/**', 'scripts/**', '*.config.*'],
    rules: { 'no-console': 'off' },
  },
)
