// The pages of the site, in the order of its sidebar: the file in the project and the name of the page. The API reference
// follows the pages of the group that `hasReference`.
export const GROUPS = [
  {
    text: 'Start',
    pages: [
      { file: 'README.md', name: 'start', text: 'Start here' },
      { file: 'docs/tutorial.md', name: 'tutorial', text: 'Tutorial' },
      { file: 'docs/recipes.md', name: 'recipes', text: 'Recipes' },
      { file: 'docs/editor.md', name: 'editor', text: 'Editor' },
    ],
  },
  {
    text: 'In CI and review',
    pages: [
      { file: 'docs/ci.md', name: 'ci', text: 'CI' },
      { file: 'docs/scale.md', name: 'scale', text: 'Large sets' },
      { file: 'docs/slurm.md', name: 'slurm', text: 'Shards on Slurm' },
      { file: 'docs/kubernetes.md', name: 'kubernetes', text: 'Shards on Kubernetes' },
      { file: 'docs/aws-batch.md', name: 'aws-batch', text: 'Shards on AWS Batch' },
      { file: 'docs/matrix.md', name: 'matrix', text: 'Shards on GitHub and GitLab' },
      { file: 'docs/gnu-parallel.md', name: 'gnu-parallel', text: 'Shards with GNU parallel' },
      { file: 'docs/ready-made.md', name: 'ready-made', text: 'Ready-made files' },
      { file: 'docs/configuration.md', name: 'configuration', text: 'Configuration' },
      { file: 'docs/reports.md', name: 'reports', text: 'Reports' },
      { file: 'docs/lock.md', name: 'lock', text: 'Agree on results' },
      { file: 'docs/diff.md', name: 'diff', text: 'What changed' },
      { file: 'docs/merging.md', name: 'merging', text: 'Merging levels' },
      { file: 'docs/compared.md', name: 'compared', text: 'Compared with six tools' },
    ],
  },
  {
    text: 'Levels',
    pages: [
      { file: 'docs/level-format.md', name: 'level-format', text: 'Level format' },
      { file: 'docs/pack.md', name: 'pack', text: 'The order of a game' },
      { file: 'docs/tune.md', name: 'tune', text: 'Rules and tuning' },
      { file: 'docs/fix.md', name: 'fix', text: 'Repair a level' },
      { file: 'docs/softlocks.md', name: 'softlocks', text: 'Where it is already lost' },
      { file: 'docs/difficulty.md', name: 'difficulty', text: 'Difficulty and new levels' },
      { file: 'docs/generate.md', name: 'generate', text: 'Levels from a seed, themes and packs' },
      { file: 'docs/import-and-export.md', name: 'import-and-export', text: 'Import and export' },
      { file: 'docs/publish.md', name: 'publish', text: 'Publish levels' },
    ],
  },
  {
    text: 'How it works',
    pages: [
      { file: 'docs/accuracy.md', name: 'accuracy', text: 'Accuracy' },
      { file: 'docs/hard-cases.md', name: 'hard-cases', text: 'Hard cases' },
      { file: 'docs/effects.md', name: 'effects', text: 'Effects' },
      { file: 'docs/determinism.md', name: 'determinism', text: 'Determinism' },
      { file: 'docs/proofs.md', name: 'proofs', text: 'Proofs' },
      { file: 'docs/glossary.md', name: 'glossary', text: 'Glossary' },
    ],
  },
  {
    text: 'Programs',
    hasReference: true,
    pages: [
      { file: 'docs/library.md', name: 'library', text: 'Library' },
      { file: 'docs/phaser.md', name: 'phaser', text: 'Phaser' },
      { file: 'docs/plays.md', name: 'plays', text: 'Plays that can be verified' },
      { file: 'docs/versioning.md', name: 'versioning', text: 'Versions' },
    ],
  },
  {
    text: 'Changing the toolkit',
    pages: [
      { file: 'CONTRIBUTING.md', name: 'contributing', text: 'Contributing' },
      { file: 'ARCHITECTURE.md', name: 'architecture', text: 'Architecture' },
      { file: 'docs/engine.md', name: 'engine', text: 'How the engine works' },
      { file: 'docs/extending.md', name: 'extending', text: 'Extending the toolkit' },
      { file: 'docs/decisions.md', name: 'decisions', text: 'Where the rules leave a choice' },
      { file: 'bench/README.md', name: 'benchmarks', text: 'Benchmarks' },
      { file: 'SECURITY.md', name: 'security', text: 'Security' },
      { file: 'CHANGELOG.md', name: 'changelog', text: 'Changelog' },
    ],
  },
];

export const PAGES = GROUPS.flatMap(({ pages }) => pages);
