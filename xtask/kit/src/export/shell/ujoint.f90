! PROPS    1-9     triad of a at the start: e1a, e2a, e3a
!          10-18   triad of b at the start
!          19-21   components of xb - xa in a's triad at the start
!          22      e1a.e3b at the start
!          23-24   alpha0, gamma0: angles about e1a and e3b at the start
!          25-26   moments per radian about e1a and e3b while they stick; the first is 0: smooth
!          27-30   rp, la, ra, ls: radius of the pins, length of an arm, friction arm of the axial force, overlap
!          31-33   internal contact moments about e1a and e3b, friction coefficient
! SVARS    1-2     ur1, ur3: turns about e1a and e3b since the start, followed beyond half a turn
!          3-4     m1, m3: friction moments about them
! internal f1, f2, f3: forces on b along e1a, e2a, e3a; the multiplier of e1a.e3b
---
! UJOINT with friction, as it enters a step of Newton's method: JOIN and UNIVERSAL, and ALIGN's moments of the friction.
! Free of conditions (CC0-1.0).
module jp_connector
    use jointproof
    use jp_element
    implicit none
    private
    public :: connect
    integer, parameter, public :: multipliers = 4, states = 4, properties = 33
    real(dp), parameter :: pi = acos(-1.0_dp)
contains
    subroutine connect(a, b, xa, xb, lambda, props, before, after, residual, rows, force, stiffness, &
            by_multipliers, code)
        real(dp), intent(in) :: a(3, 3), b(3, 3), xa(3), xb(3), lambda(multipliers), props(:), before(states)
        real(dp), intent(out) :: after(states), residual(multipliers), rows(multipliers, 12), force(12), &
            stiffness(12, 12), by_multipliers(12, multipliers)
        integer, intent(out) :: code
        real(dp) :: g(9, 3), ta(3), tb(3), fa(3), ma(3), fb(3), na(3), nb(3), ua_ta(9), ta_ta(9), own(9), &
            ta_tb(9), tb_tb(9)

        after = before
        code = jp_ujoint_constraint_value(a(:, 1), a(:, 2), a(:, 3), b(:, 3), xa, xb, props(1:3), props(4), &
            residual(1:3), residual(4))
        if (code /= 0) return
        code = jp_join_rows_value(a(:, 1), a(:, 2), a(:, 3), xa, xb, g(1:3, 1), g(4:6, 1), g(7:9, 1), &
            g(1:3, 2), g(4:6, 2), g(7:9, 2), g(1:3, 3), g(4:6, 3), g(7:9, 3))
        if (code /= 0) return
        code = jp_universal_rows_value(a(:, 1), b(:, 3), ta, tb)
        if (code /= 0) return
        code = jp_join_nodal_forces_value(a(:, 1), a(:, 2), a(:, 3), xa, xb, lambda(1), lambda(2), lambda(3), fa, ma, fb)
        if (code /= 0) return
        code = jp_universal_nodal_moments_value(a(:, 1), b(:, 3), lambda(4), na, nb)
        if (code /= 0) return
        code = jp_join_geometric_stiffness_value(a(:, 1), a(:, 2), a(:, 3), xa, xb, lambda(1), lambda(2), lambda(3), &
            ua_ta, ta_ta)
        if (code /= 0) return
        code = jp_universal_geometric_stiffness_value(a(:, 1), b(:, 3), lambda(4), own, ta_tb, tb_tb)
        if (code /= 0) return

        rows(1:3, :9) = transpose(g)
        rows(1:3, 10:) = 0
        rows(4, :) = spins(ta, tb)
        force = nodal(fa, ma + na, fb, nb)
        stiffness = along(block(ua_ta), block(ta_ta + own))
        call put(stiffness, 2, 4, block(ta_tb))
        call put(stiffness, 4, 2, transpose(block(ta_tb)))
        call put(stiffness, 4, 4, block(tb_tb))
        by_multipliers = transpose(rows)
        if (props(7) > 0) call rub(a, b, lambda, props, before, rows(4, :), after, force, stiffness, by_multipliers, code)
    end subroutine connect

    ! Friction about both axes of the cross: it works against the angles, as the opposite of multipliers of ALIGN.
    subroutine rub(a, b, lambda, props, before, twisting, after, force, stiffness, by_multipliers, code)
        real(dp), intent(in) :: a(3, 3), b(3, 3), lambda(multipliers), props(:), before(states), twisting(12)
        real(dp), intent(inout) :: after(states), force(12), stiffness(12, 12), by_multipliers(12, multipliers)
        integer, intent(out) :: code
        real(dp) :: alpha, gamma, m1, m3, by_turn(2), sine, cosine, m2, mc(2), mn(2), contact(20, 2), by_contact(4, 2), &
            na(3), nb(3), tb_tb(9), r(3, 3), aligning(12, 12), by_m2(12)

        code = jp_universal_angles_value(a(:, 1), a(:, 2), a(:, 3), b(:, 1), b(:, 2), b(:, 3), alpha, gamma)
        if (code /= 0) return
        after(1) = nearest_turn(alpha - props(5), before(1))
        after(2) = nearest_turn(gamma - props(6), before(2))
        ! The twisting moment is conjugate to the second angle, the multiplier to its sine.
        sine = dot(a(:, 1), b(:, 3))
        cosine = sqrt((1 - sine) * (1 + sine))
        m2 = lambda(4) * cosine
        code = jp_ujoint_contact_moments_jacobian(a(:, 1), a(:, 2), a(:, 3), b(:, 3), lambda(1), lambda(2), lambda(3), m2, &
            props(9), props(10), props(11), props(12), mc(1), mc(2), contact)
        if (code /= 0) return
        code = jp_ujoint_normal_moments_jacobian(mc(1), mc(2), props(13), props(14), mn(1), mn(2), by_contact)
        if (code /= 0) return
        call slide(1, by_contact(1, 1), m1, code)
        if (code /= 0) return
        call slide(2, by_contact(2, 2), m3, code)
        if (code /= 0) return
        code = jp_align_nodal_moments_value(a(:, 1), a(:, 2), a(:, 3), b(:, 1), b(:, 2), b(:, 3), -m1, 0.0_dp, -m3, na, nb)
        if (code /= 0) return
        code = jp_align_geometric_stiffness_value(a(:, 1), a(:, 2), a(:, 3), b(:, 1), b(:, 2), b(:, 3), -m1, 0.0_dp, -m3, tb_tb)
        if (code /= 0) return
        code = jp_align_rows_value(a(:, 1), a(:, 2), a(:, 3), b(:, 1), b(:, 2), b(:, 3), r(:, 1), r(:, 2), r(:, 3))
        if (code /= 0) return
        force = force + spins(na, nb)
        aligning = 0
        call put(aligning, 2, 2, transpose(block(tb_tb)))
        call put(aligning, 2, 4, -block(tb_tb))
        call put(aligning, 4, 2, -transpose(block(tb_tb)))
        call put(aligning, 4, 4, block(tb_tb))
        stiffness = stiffness + aligning
        by_m2 = twisting * (-(lambda(4) * sine) / cosine)
        call follow(r(:, 1), contact(:, 1), by_turn(1))
        call follow(r(:, 3), contact(:, 2), by_turn(2))
    contains
        ! The friction moment about an axis, and what the loads do to it in place of what they do to the contact moment.
        subroutine slide(axis, by_normal, moment, code)
            integer, intent(in) :: axis
            real(dp), intent(in) :: by_normal
            real(dp), intent(out) :: moment
            integer, intent(out) :: code
            real(dp) :: slope(10), slip
            code = jp_coulomb_response_jacobian(after(axis) - before(axis), before(2 + axis), props(6 + axis), props(15), &
                mn(axis), moment, slip, slope)
            after(2 + axis) = moment
            by_turn(axis) = slope(1)
            contact(:, axis) = contact(:, axis) * (slope(5) * by_normal)
        end subroutine slide

        ! What the change of a friction moment adds: with its own angle, with the triads, with the multipliers.
        subroutine follow(turn, by, by_own)
            real(dp), intent(in) :: turn(3), by(20), by_own
            real(dp) :: row(12), by_ta(3)
            row = spins(-turn, turn)
            by_ta = cross(a(:, 1), by(1:3)) + cross(a(:, 2), by(4:6)) + cross(a(:, 3), by(7:9))
            stiffness = stiffness - outer(row, row * by_own + spins(by_ta, cross(b(:, 3), by(10:12))) + by_m2 * by(16))
            by_multipliers = by_multipliers - outer(row, [by(13:15), by(16) * cosine])
        end subroutine follow
    end subroutine rub

    ! An angle and as many full turns as bring it nearest to the last one.
    pure function nearest_turn(angle, last)
        real(dp), intent(in) :: angle, last
        real(dp) :: nearest_turn
        nearest_turn = angle
        if (abs(anint((last - angle) / (2 * pi))) > 0) nearest_turn = angle + pi * (2 * anint((last - angle) / (2 * pi)))
    end function nearest_turn
end module jp_connector
