export { type NativeArcade, type NativeScene, startNative } from './native-arcade.ts';
