// The drawing of the report, once: its scripts add to window.report, in this order.
import '../../MyRigidbody.Lab/Report/Page/solid.js';
import '../../MyRigidbody.Lab/Report/Page/motion.js';
import '../../MyRigidbody.Lab/Report/Page/stage.js';
import '../../MyRigidbody.Lab/Report/Page/look.js';
import '../../MyRigidbody.Lab/Report/Page/replay.js';
