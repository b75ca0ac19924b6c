import type { Shape } from './shape.ts';

// Made from the schema of level files by `npx vitest run tests/schema/plain.test.ts --update`: not to be edited.
/** The shape of a level file. */
export const LEVEL_SHAPE: Shape = {
 type: "object",
 keys: {
  $schema: {
   type: "string",
   optional: true
  },
  version: {
   type: "number",
   only: 1
  },
  conflicts: {
   type: "array",
   most: 20000,
   each: {
    type: "object",
    keys: {
     what: {
      type: "string"
     },
     key: {
      type: "string",
      least: 1
     },
     base: {
      optional: true
     },
     ours: {
      optional: true
     },
     theirs: {
      optional: true
     }
    }
   },
   optional: true
  },
  name: {
   type: "string",
   least: 1,
   most: 120
  },
  description: {
   type: "string",
   most: 2000,
   optional: true,
   usual: ""
  },
  astronaut: {
   type: "object",
   keys: {
    x: {
     type: "number",
     least: -1000000000,
     most: 1000000000
    },
    y: {
     type: "number",
     least: -1000000000,
     most: 1000000000
    },
    vx: {
     type: "number",
     least: -1000,
     most: 1000,
     optional: true,
     usual: 0
    },
    vy: {
     type: "number",
     least: -1000,
     most: 1000,
     optional: true,
     usual: 0
    }
   }
  },
  blackHole: {
   type: "object",
   keys: {
    x: {
     type: "number",
     least: -1000000000,
     most: 1000000000
    },
    y: {
     type: "number",
     least: -1000000000,
     most: 1000000000
    },
    radius: {
     type: "number",
     least: 0.001,
     most: 1000000,
     optional: true,
     usual: 18
    }
   }
  },
  range: {
   type: "number",
   least: 0.001,
   most: 1000000,
   optional: true,
   usual: 250
  },
  recoil: {
   type: "boolean",
   optional: true,
   usual: false
  },
  rules: {
   type: "object",
   keys: {
    pull: {
     type: "number",
     least: 1,
     most: 1000,
     optional: true
    },
    recoil: {
     type: "number",
     least: 0,
     most: 1000,
     optional: true
    },
    push: {
     type: "number",
     least: 1,
     most: 1000,
     optional: true
    },
    alienPull: {
     type: "number",
     least: 0,
     most: 1000,
     optional: true
    },
    alienSight: {
     type: "number",
     least: 0,
     most: 10000,
     optional: true
    },
    speedLimit: {
     type: "number",
     least: 10,
     most: 1000,
     optional: true
    },
    boxWidth: {
     type: "number",
     least: 1,
     most: 200,
     optional: true
    },
    boxHeight: {
     type: "number",
     least: 1,
     most: 200,
     optional: true
    }
   },
   optional: true
  },
  allow: {
   type: "object",
   keys: {
    "run-does-not-complete": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "found-run": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "mineral-never-collectable": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    softlock: {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "low-slack": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "slack-below-required": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "verdict-hangs-on-accuracy": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "work-limit": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "nothing-in-range-at-start": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "starts-in-hazard": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "touches-black-hole-at-start": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "black-hole-out-of-reach": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "black-hole-covered": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "mineral-out-of-reach": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "mineral-covered": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "aliens-explode-at-start": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "repulsor-never-acts": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "same-place": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    overlapping: {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "holds-overlap": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "holds-unsorted": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    },
    "unused-asteroid": {
     type: "string",
     least: 1,
     most: 300,
     pattern: "\\S",
     optional: true
    }
   },
   optional: true
  },
  asteroids: {
   type: "array",
   most: 20000,
   each: {
    type: "object",
    keys: {
     id: {
      type: "string",
      pattern: "^[a-z0-9]{2,16}$",
      optional: true,
      usual: null
     },
     x: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     y: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     radius: {
      type: "number",
      least: 0.001,
      most: 1000000
     },
     hot: {
      type: "boolean",
      optional: true,
      usual: false
     }
    }
   },
   optional: true,
   usual: []
  },
  novae: {
   type: "array",
   most: 20000,
   each: {
    type: "object",
    keys: {
     id: {
      type: "string",
      pattern: "^[a-z0-9]{2,16}$",
      optional: true,
      usual: null
     },
     x: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     y: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     radius: {
      type: "number",
      least: 0.001,
      most: 1000000
     }
    }
   },
   optional: true,
   usual: []
  },
  repulsors: {
   type: "array",
   most: 20000,
   each: {
    type: "object",
    keys: {
     id: {
      type: "string",
      pattern: "^[a-z0-9]{2,16}$",
      optional: true,
      usual: null
     },
     x: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     y: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     radius: {
      type: "number",
      least: 0.001,
      most: 1000000
     }
    }
   },
   optional: true,
   usual: []
  },
  aliens: {
   type: "array",
   most: 20000,
   each: {
    type: "object",
    keys: {
     id: {
      type: "string",
      pattern: "^[a-z0-9]{2,16}$",
      optional: true,
      usual: null
     },
     x: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     y: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     radius: {
      type: "number",
      least: 0.001,
      most: 1000000,
      optional: true,
      usual: 25
     }
    }
   },
   optional: true,
   usual: []
  },
  minerals: {
   type: "array",
   most: 20000,
   each: {
    type: "object",
    keys: {
     id: {
      type: "string",
      pattern: "^[a-z0-9]{2,16}$",
      optional: true,
      usual: null
     },
     x: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     y: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     radius: {
      type: "number",
      least: 0.001,
      most: 1000000,
      optional: true,
      usual: 7
     }
    }
   },
   optional: true,
   usual: []
  },
  winds: {
   type: "array",
   most: 20000,
   each: {
    type: "object",
    keys: {
     id: {
      type: "string",
      pattern: "^[a-z0-9]{2,16}$",
      optional: true,
      usual: null
     },
     x: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     y: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     radius: {
      type: "number",
      least: 0.001,
      most: 1000000
     },
     ax: {
      type: "number",
      least: -100,
      most: 100,
      optional: true,
      usual: 0
     },
     ay: {
      type: "number",
      least: -100,
      most: 100,
      optional: true,
      usual: -20
     }
    }
   },
   optional: true,
   usual: []
  },
  wormholes: {
   type: "array",
   most: 20000,
   each: {
    type: "object",
    keys: {
     id: {
      type: "string",
      pattern: "^[a-z0-9]{2,16}$",
      optional: true,
      usual: null
     },
     x: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     y: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     toX: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     toY: {
      type: "number",
      least: -1000000000,
      most: 1000000000
     },
     radius: {
      type: "number",
      least: 0.001,
      most: 1000000
     }
    }
   },
   optional: true,
   usual: []
  },
  runs: {
   type: "array",
   most: 1000,
   each: {
    type: "object",
    keys: {
     name: {
      type: "string",
      least: 1,
      most: 80
     },
     holds: {
      type: "array",
      most: 20000,
      each: {
       type: "array",
       least: 2,
       most: 2,
       each: {
        type: "integer",
        least: 0,
        most: 216000
       }
      }
     },
     notes: {
      type: "array",
      most: 1000,
      each: {
       type: "object",
       keys: {
        tick: {
         type: "integer",
         least: 0,
         most: 216000
        },
        text: {
         type: "string",
         least: 1,
         most: 200,
         pattern: "^[^\\s\\x85](?:[^\\n-\\r\\x85\\u2028\\u2029]*[^\\s\\x85])?$"
        }
       }
      },
      optional: true
     }
    }
   },
   optional: true,
   usual: []
  }
 }
};
