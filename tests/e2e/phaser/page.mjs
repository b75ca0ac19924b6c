// A game that plays a level's own run: what the bundlers of tests/e2e/phaser.test.ts bundle, once with each major of Phaser.
import { readLevel } from 'gravity-quest-toolkit/game';
import { createRunner } from 'gravity-quest-toolkit/phaser';
import * as imported from 'phaser';

const Phaser = imported.Game === undefined ? imported.default : imported;

globalThis.gravityQuestTest = { Phaser, createRunner, readLevel };
