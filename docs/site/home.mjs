/** What stands at the head of the start page. */
export const HOME = {
  layout: 'home',
  hero: {
    name: 'Gravity Quest toolkit',
    text: 'Levels that can be completed',
    tagline:
      'Check levels, find runs, prove levels impossible, measure how hard they are: on the command line and in the browser.',
    image: {
      dark: '/firewalk.svg',
      light: '/light-firewalk.svg',
      alt: 'The level Firewalk: a run past three hot asteroids and three novae into the black hole',
    },
    actions: [
      { theme: 'brand', text: 'Tutorial', link: '/tutorial' },
      { theme: 'alt', text: 'Start here', link: '/start' },
      { theme: 'alt', text: 'Level format', link: '/level-format' },
    ],
  },
  features: [
    { title: 'Check', details: 'What is wrong with a level, in which line, and what to do about it. Made for CI.', link: '/ci' },
    {
      title: 'Edit',
      details: 'Drag an object: the run bends and the verdict follows. Play in place, undo everything.',
      link: '/editor',
    },
    {
      title: 'Solve',
      details: 'Finds the run that forgives bad timing most, with as many minerals as you ask for.',
      link: '/recipes',
    },
    { title: 'Prove', details: 'Proves that nobody can complete a level. A separate checker confirms it.', link: '/proofs' },
    { title: 'Tune', details: 'What a stronger pull of the gun does to every level of a pack.', link: '/tune' },
    { title: 'Measure', details: 'How hard a level is, how exact a run is, and what that costs.', link: '/difficulty' },
  ],
};
